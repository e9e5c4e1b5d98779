// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/rules/adaptive/adaptive_rule.hpp"

namespace fde {

// Dense output of a run with adaptive step size, from the polynomials of D^g y on its steps: y at any time up
// to the last,
//   y_i(t) = Taylor part + the fractional integral of all polynomials up to t,
// summed directly, except for interpolated components (see InterpolatedRow). The cost of a value is
// proportional to the number of steps before it, some ten nanoseconds each.
class DenseOutput {
 public:
  explicit DenseOutput(const Problem& problem);

  // Adds the step from the end of the previous one to t: D^g y on it, its interpolated components, and the
  // slopes that are left out of its polynomials.
  void add(double t, const DerivativePolynomials& derivatives, const InterpolatedRows& interpolated,
           const Matrix& slopes);

  // y at t. Precondition: 0 <= t <= the end of the last step.
  [[nodiscard]] Vec at(double t) const;

  void state(Archive& archive);

 private:
  // All components of one order; order 0: the algebraic rows.
  struct OrderGroup {
    double order;
    std::vector<Eigen::Index> rows;
  };
  [[nodiscard]] Eigen::Map<const DerivativePolynomials> derivatives_on(std::size_t step) const;

  TaylorPart taylor_;
  Eigen::Index size_;
  std::vector<OrderGroup> groups_;
  std::vector<double> times_{0.0};
  InterpolatedRows interpolated_;
  std::vector<std::size_t> interpolated_offsets_{0};  // index of the first one of each step, and their number
  // The steps whose polynomials leave out slopes, which are few, and the slopes.
  std::vector<std::size_t> sloped_steps_{};
  std::vector<Matrix> slopes_{};
  std::vector<double> derivatives_;  // step after step, as coefficients of Legendre polynomials
};

}  // namespace fde
