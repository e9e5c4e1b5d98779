// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/retained_columns.hpp"

#include <limits>
#include <utility>

namespace fde::bench {

RetainedColumns::RetainedColumns(const Outputs& outputs, std::vector<double> times, double unit)
    : outputs_(outputs), requested_(std::move(times)), unit_(unit) {}

void RetainedColumns::observe(double t, In y) {
  if (!requested_.empty() && (t < next_from_ || !is_requested(t))) return;
  const Vec columns = columns_at(outputs_, t, unit_ * y);
  const auto count = std::ssize(times_);
  if (count == columns_.cols()) columns_.conservativeResize(columns.size(), 2 * count + 16);
  columns_.col(count) = columns;
  times_.push_back(t);
}

bool RetainedColumns::is_requested(double t) {
  constexpr double rounding = 1e-12;
  while (next_ < requested_.size() && requested_[next_] < t * (1 - rounding)) ++next_;
  next_from_ = next_ < requested_.size() ? requested_[next_] * (1 - 2 * rounding)
                                         : std::numeric_limits<double>::infinity();
  return next_ < requested_.size() && requested_[next_] <= t * (1 + rounding);
}

void RetainedColumns::state(Archive& archive) {
  archive.count(next_, 0, requested_.size());
  archive.resizable(times_);
  archive.first_columns(columns_, std::ssize(times_));
}

}  // namespace fde::bench
