// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/error_tolerance.hpp"

#include <limits>

namespace fde {

namespace {

// Bound for the rounding errors in each row, from the largest |y| of the row and the size of its terms.
Eigen::ArrayXd noise(const Eigen::ArrayXd& largest, In terms) {
  constexpr double above_rounding = 50.0 * std::numeric_limits<double>::epsilon();
  // Smaller errors would involve subnormal numbers, in which Newton's method loses relative accuracy.
  constexpr double smallest = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  return (above_rounding * largest.max(terms.array())).max(smallest);
}

}  // namespace

Vec ErrorTolerance::on_step(In least, In largest, In terms, In unresolved) const {
  constexpr double of_row = 0.01;
  // The absolute tolerance decides above this share of the relative one; largest growth of a row that counts.
  constexpr double counts = 1e-3, growth = 16.0;
  const bool by_least = accuracy_.atol > counts * accuracy_.rtol;
  const Eigen::ArrayXd size = by_least ? least.array() : largest.array();
  const Eigen::ArrayXd allowed = accuracy_.atol + accuracy_.rtol * size;
  Eigen::ArrayXd rounded = largest.array();
  if (by_least) rounded = rounded.min(growth / accuracy_.rtol * allowed);
  const Eigen::ArrayXd rounding = noise(rounded, terms);
  if (largest_.size() == 0) return allowed.max(rounding);
  const auto starts_from_rest = largest_.array() <= (after_jump_ ? of_row : 0.0) * largest.array();
  const auto by_size = of_row * largest.array().max(largest_.array());
  return starts_from_rest.select(allowed, allowed.min(by_size.max(unresolved.array()))).max(rounding);
}

Vec ErrorTolerance::from_tolerance(In largest, In terms) const {
  return (accuracy_.atol + accuracy_.rtol * largest.array()).max(noise(largest.array(), terms));
}

double ErrorTolerance::error_of_outputs(const Problem& problem, double t, In y, In errors, In terms) const {
  if (!problem.outputs) return 0.0;
  const Eigen::ArrayXd rounding = noise(y.array().abs(), terms);
  const Vec counted = (errors.array().abs() > rounding).select(errors, 0.0);
  const Vec outputs = problem.outputs(t, y), moved = problem.outputs(t, y + counted);
  const Eigen::ArrayXd allowed = accuracy_.atol + accuracy_.rtol * outputs.array().abs();
  return ((moved - outputs).array().abs() / allowed).maxCoeff();
}

void ErrorTolerance::accept_step(In largest) {
  if (largest_.size() == 0) largest_ = largest;
  largest_ = largest_.cwiseMax(largest);
  after_jump_ = false;
}

}  // namespace fde
