#pragma once

#include <vector>

#include "adaptive/adaptive_steps.hpp"

namespace fde {

// What a run of steps leaves on which drives are polynomials: y at any time up to the last,
//   y_i(t) = Taylor part + the fractional integral of all polynomials up to t,
// summed as it stands, but for rows of a step that are known by their values. A value costs as much as there
// are steps before it, some ten nanoseconds each.
class DensePath {
 public:
  explicit DensePath(const Problem& problem);

  // The drives from the end of the step before up to t, and the rows that are known better.
  void add(double t, const Drives& drives, const InterpolatedRows& interpolated);

  // 0 <= t <= the end of the last step.
  [[nodiscard]] Vec at(double t) const;

  void state(Archive& archive);

 private:
  // All rows of one order; 0: algebraic ones.
  struct Group {
    double order;
    std::vector<Eigen::Index> rows;
  };
  [[nodiscard]] Eigen::Map<const Drives> drives_of(std::size_t step) const;

  TaylorPart taylor_;
  Eigen::Index size_;
  std::vector<Group> groups_;
  std::vector<double> times_{0.0};
  InterpolatedRows interpolated_;
  std::vector<std::size_t> interpolated_from_{0};  // of each step, and of the next
  std::vector<double> drives_;  // of one step after the other, as coefficients of Legendre polynomials
};

}  // namespace fde
