// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// Compensated running sums (Neumaier), one a component.
class RunningSums {
 public:
  explicit RunningSums(Eigen::Index size) : total_(Vec::Zero(size)), carry_(Vec::Zero(size)) {}

  void add(Eigen::Index i, double value) {
    const double old = total_[i];
    total_[i] = old + value;
    carry_[i] += std::abs(old) >= std::abs(value) ? (old - total_[i]) + value : (value - total_[i]) + old;
  }
  void add(In values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) add(i, values[i]);
  }
  [[nodiscard]] double operator[](Eigen::Index i) const { return total_[i] + carry_[i]; }
  [[nodiscard]] Eigen::Index size() const { return total_.size(); }
  void state(Archive& archive) { archive(total_, carry_); }

 private:
  Vec total_, carry_;
};

}  // namespace fde
