#include "history/filtered_memory.hpp"

namespace fde {

namespace {

// phi_L, ..., phi_1, filled up in front with 0.
Vec reversed_tail(const std::vector<double>& filter) {
  constexpr Eigen::Index together = 4 * lanes;  // that dot_product takes at a time
  const auto count = std::ssize(filter) - 1;
  Vec tail = Vec::Zero((count + together - 1) / together * together);
  for (Eigen::Index i = 1; i <= count; ++i) tail[tail.size() - i] = filter[static_cast<std::size_t>(i)];
  return tail;
}

}  // namespace

FilteredMemory::FilteredMemory(const WeightTable& table, Eigen::Index components, double longest,
                               double tolerance)
    : running_sums_(table.order > 1.0),
      filter_(reversed_tail(table.family->filter(table.order))),
      window_(Matrix::Zero(2 * filter_.size(), components)),
      next_(filter_.size()),
      tail_(Vec::Zero(components)),
      filtered_(components),
      totals_(components) {
  const WeightTable binomial{&families::grunwald_letnikov, table.order};
  if (constant_weight(binomial)) return;
  memory_.emplace(
      std::vector{binomial}, components,
      exponential_sum(kernel_exponent(binomial), ExponentialMemory::shortest_lag, longest, tolerance));
}

void FilteredMemory::push(In sample) {
  filtered_ = sample + tail_;
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
  window_.row(next_++) = sample;
  for (Eigen::Index i = 0; i < sample.size(); ++i)
    tail_[i] = dot_product(filter_.data(), window_.col(i).data() + next_ - length, length);
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
