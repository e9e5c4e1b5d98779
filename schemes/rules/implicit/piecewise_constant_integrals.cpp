// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/piecewise_constant_integrals.hpp"

#include <limits>

namespace fde {

PiecewiseConstantIntegrals::PiecewiseConstantIntegrals(const Problem& problem,
                                                       const std::vector<Eigen::Index>& components,
                                                       const Grid& grid, const Options& options)
    : totals_(problem.size()) {
  for (const auto i : components) {
    const double order = problem.components[static_cast<std::size_t>(i)].order;
    if (order < 1.0) tables_.push_back({&families::l1, 1.0 - order});
    (order < 1.0 ? below_ : order > 1.0 ? above_ : whole_).push_back(i);
  }
  if (below_.empty()) return;
  buffer_.resize(std::ssize(below_));
  fractional_ = make_history(options.history, {tables_}, step_plan(grid), options.tolerance);
}

void PiecewiseConstantIntegrals::push(double t, double length, In values) {
  for (const auto i : whole_) totals_.add(i, length * values[i]);
  for (const auto i : above_) {
    if (values[i] != 0.0) totals_.add(i, std::numeric_limits<double>::quiet_NaN());
  }
  if (!fractional_) return;
  buffer_ = length * values(below_);
  fractional_->push(t, buffer_);
}

void PiecewiseConstantIntegrals::add_integrals(double t, double length, Out sums) {
  for (const auto i : whole_) sums[i] += totals_[i];
  for (const auto i : above_) sums[i] += totals_[i];
  if (!fractional_) return;
  fractional_->convolve(t, 0, buffer_);
  for (Eigen::Index r = 0; r < buffer_.size(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    sums[below_[at]] += buffer_[r] / step_factor(tables_[at], length);
  }
}

}  // namespace fde
