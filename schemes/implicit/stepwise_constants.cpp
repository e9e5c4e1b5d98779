#include "implicit/stepwise_constants.hpp"

#include <limits>

namespace fde {

StepwiseConstants::StepwiseConstants(const Problem& problem, const Grid& grid, const Options& options)
    : problem_(problem), totals_(problem.size()) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& component = problem.components[static_cast<std::size_t>(i)];
    if (algebraic(component) || component.order >= 1.0) continue;
    below_.push_back(i);
    tables_.push_back({&families::l1, 1.0 - component.order});
  }
  if (below_.empty()) return;
  buffer_.resize(std::ssize(below_));
  fractional_ = make_history(options.history, {tables_}, step_plan(grid), options.tolerance);
}

void StepwiseConstants::push(double t, double length, In values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double order = problem_.components[static_cast<std::size_t>(i)].order;
    if (order == 1.0) totals_.add(i, length * values[i]);
    if (order > 1.0 && values[i] != 0.0) totals_.add(i, std::numeric_limits<double>::quiet_NaN());
  }
  if (!fractional_) return;
  buffer_ = length * values(below_);
  fractional_->push(t, buffer_);
}

void StepwiseConstants::add_integrals(double t, double length, Out sums) {
  for (Eigen::Index i = 0; i < sums.size(); ++i) sums[i] += totals_[i];
  if (!fractional_) return;
  fractional_->convolve(t, 0, buffer_);
  for (Eigen::Index r = 0; r < buffer_.size(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    sums[below_[at]] += buffer_[r] / step_factor(tables_[at], length);
  }
}

}  // namespace fde
