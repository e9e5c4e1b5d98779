// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/filtered_memory.hpp"

#include "fdebench/schemes/problem/componentwise.hpp"

namespace fde {

namespace {

// phi_L, ..., phi_2, with zeros in front.
Vec reversed_tail(const std::vector<double>& filter) {
  const auto count = std::max<std::ptrdiff_t>(std::ssize(filter) - 2, 0);
  Vec tail = Vec::Zero((count + lanes - 1) / lanes * lanes);
  for (Eigen::Index i = 1; i <= count; ++i) tail[tail.size() - i] = filter[static_cast<std::size_t>(i) + 1];
  return tail;
}

double first_coefficient(const std::vector<double>& filter) { return filter.size() > 1 ? filter[1] : 0.0; }

}  // namespace

FilteredMemory::FilteredMemory(const WeightTable& table, Eigen::Index components, int steps, double tolerance)
    : running_sums_(table.order > 1.0),
      filter_(reversed_tail(table.family->filter(table.order))),
      first_(first_coefficient(table.family->filter(table.order))),
      window_(Matrix::Zero(2 * filter_.size() + 1, components)),
      next_(filter_.size()),
      tail_(Vec::Zero(components)),
      filtered_(components),
      totals_(components) {
  const WeightTable binomial{&families::grunwald_letnikov, table.order};
  if (constant_weight(binomial)) return;
  memory_.emplace(std::vector{binomial}, components, steps, tolerance);
}

void FilteredMemory::push(In sample) {
  for_each_component(sample.size(), [&](Eigen::Index i) { filtered_[i] = sample[i] + tail_[i]; });
  if (!memory_ || running_sums_) totals_.add(filtered_);
  if (running_sums_) {
    for (Eigen::Index i = 0; i < filtered_.size(); ++i) filtered_[i] = totals_[i];
  }
  if (memory_) memory_->push(filtered_);
  const Eigen::Index length = filter_.size();
  if (next_ == window_.rows()) {
    window_.topRows(length) = window_.bottomRows(length);
    next_ = length;
  }
  for (Eigen::Index i = 0; i < sample.size(); ++i) {
    double* const newest = window_.col(i).data() + next_;
    *newest = sample[i];
    tail_[i] = dot_product(filter_.data(), newest - length, length) + first_ * sample[i];
  }
  ++next_;
}

std::size_t FilteredMemory::bytes() const {
  const auto doubles = filter_.size() + window_.size() + 4 * tail_.size();
  return sizeof(double) * static_cast<std::size_t>(doubles) + (memory_ ? memory_->bytes() : 0);
}

void FilteredMemory::state(Archive& archive) {
  archive.count(next_, filter_.size(), window_.rows());
  archive(window_, tail_, totals_, memory_);
}

}  // namespace fde
