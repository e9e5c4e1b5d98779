// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/direct_history.hpp"

#include <algorithm>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/problem/large_pages.hpp"

namespace fde {

DirectHistory::DirectHistory(const WeightTables& tables, int steps)
    : steps_(steps), totals_(static_cast<Eigen::Index>(tables.front().size())) {
  std::vector<WeightTable> distinct;
  for (const auto& sum : tables) {
    auto& parts = parts_.emplace_back();
    for (const auto& table : sum) parts.push_back(part(table, distinct));
  }
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < tables.front().size(); ++i) {
    const bool remembers = std::ranges::any_of(parts_, [&](const auto& sum) { return sum[i].column >= 0; });
    row_.push_back(remembers ? rows++ : -1);
  }
  allocate(samples_, steps_, rows);
  weights_.resize(steps_, static_cast<Eigen::Index>(distinct.size()));
  starts_.resizeLike(weights_);
  for (Eigen::Index c = 0; c < weights_.cols(); ++c) {
    const auto& table = distinct[static_cast<std::size_t>(c)];
    weights_.col(c) = first_weights(table, steps_).reverse();
    for (Eigen::Index k = 1; k <= steps_; ++k) {
      starts_(k - 1, c) = first_sample_weight(table, k).value_or(weights_(steps_ - k, c));
    }
  }
}

DirectHistory::Part DirectHistory::part(const WeightTable& table, std::vector<WeightTable>& distinct) {
  if (const auto constant = constant_weight(table)) {
    return {.start = first_sample_weight(table, 1).value_or(*constant), .constant = *constant, .column = -1};
  }
  auto found = std::ranges::find(distinct, table);
  if (found == distinct.end()) found = distinct.insert(found, table);
  return {.start = 0.0, .constant = 0.0, .column = found - distinct.begin()};
}

void DirectHistory::push(double /*t*/, In sample) {
  for (Eigen::Index i = 0; i < sample.size(); ++i) {
    if (const auto row = row_[static_cast<std::size_t>(i)]; row >= 0) samples_(pushed_, row) = sample[i];
  }
  if (pushed_++ == 0) {
    first_ = sample;
    return;
  }
  totals_.add(sample);
}

void DirectHistory::convolve(double /*t*/, std::size_t sum, Out result) const {
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const auto& part = parts_[sum][static_cast<std::size_t>(i)];
    if (part.column < 0) {
      result[i] = part.start * first_[i] + part.constant * totals_[i];
    } else {
      const double* const older = samples_.col(row_[static_cast<std::size_t>(i)]).data() + 1;
      const double* const weights = weights_.col(part.column).data() + steps_ - (pushed_ - 1);
      result[i] = starts_(pushed_ - 1, part.column) * first_[i] + dot_product(weights, older, pushed_ - 1);
    }
  }
}

std::size_t DirectHistory::bytes() const {
  return sizeof(double) *
         static_cast<std::size_t>(weights_.size() + starts_.size() + samples_.size() + 3 * totals_.size());
}

void DirectHistory::state(Archive& archive) {
  archive.count(pushed_, 0, steps_);
  archive.resizable(first_);
  archive(totals_);
  for (Eigen::Index row = 0; row < samples_.cols(); ++row) archive.values(samples_.col(row).data(), pushed_);
}

}  // namespace fde
