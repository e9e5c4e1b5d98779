// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The results of the steps over a grid and polynomials between them: y at any time up to the last. Each
// polynomial is through up to eight results next to the time, more than the highest order of a rule, and no
// breaking point separates these: there y has a derivative that jumps or is infinite. Next to such a point y
// behaves like a power of the time since it, and the error of the first steps after it is that of the power.
class StoredResults {
 public:
  // `breaking_points` increase.
  StoredResults(In start, std::vector<double> breaking_points);

  // Appends the result of the step to t.
  void add(double t, In y);

  // y at t. Precondition: 0 <= t <= the last time, up to rounding.
  [[nodiscard]] Vec at(double t) const;

  void state(Archive& archive);

 private:
  [[nodiscard]] Eigen::Map<const Vec> result(std::size_t n) const;

  Eigen::Index size_;
  std::vector<double> times_{0.0};
  std::vector<double> results_;  // one after the other
  std::vector<double> breaking_points_;
};

}  // namespace fde
