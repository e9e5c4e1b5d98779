#include "history/memory_start.hpp"

#include <cmath>

namespace fde {
namespace {

// The weights of x_0 at the steps first, first + 1, ...
Vec exact_start(const WeightTable& table, Eigen::Index first) {
  return Vec::NullaryExpr(MemoryTables::block, [&](Eigen::Index k) {
    const auto own = start_weight(table, first + k);
    return own ? *own : weight(table, first + k);
  });
}

}  // namespace

// x_0 is the newest sample before the first block. Alone it adds nothing later; its running sum stays 1.
MemoryStart::MemoryStart(const std::vector<WeightTable>& weights, const MemoryTables& tables,
                         const ExponentialSum& sum)
    : weights_(block, tables.count),
      near_(Matrix::Zero(block, tables.count)),
      far_(weights.size()),
      states_(Vec::Zero(tables.nodes.size())),
      carries_(states_),
      input_(tables.gather.col(recent - 1)),
      later_(states_) {
  const bool running_sums = weighs_running_sums(weights.front());
  if (running_sums) {
    later_ = tables.gather.rowwise().sum();
    input_ += tables.gather.rightCols(block - recent).rowwise().sum();
  }
  Matrix decays(block, tables.nodes.size());
  for (Eigen::Index row = 0; row < block; ++row)
    decays.row(row) = (-double(recent + 1 + row) * tables.nodes).array().exp();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto table = static_cast<Eigen::Index>(i);
    weights_.col(table) = exact_start(weights[i], 1);
    const auto start = start_weight(weights[i], 1);
    if (start && *start == 0.0) continue;
    const Vec coefficients =
        start ? start_coefficients(weights[i], sum) : weight_coefficients(weights[i], sum);
    far_[i] = decays * padded(coefficients, 0.0).asDiagonal();
    if (running_sums) near_.col(table) = exact_start(weights[i], recent);
  }
}

void MemoryStart::advance_block(const MemoryTables& tables) {
  const auto count = states_.size();
  advance(count, 1, tables.decay_minus_one.data(), input_, states_, carries_);
  input_ = later_;
  weights_ = near_;
  for (std::size_t i = 0; i < far_.size(); ++i) {
    if (far_[i].size() == 0) continue;
    multiply_add(block, count, 1, far_[i], states_, {&weights_(0, static_cast<Eigen::Index>(i)), block});
  }
}

std::size_t MemoryStart::bytes() const {
  Eigen::Index doubles = 2 * weights_.size() + 4 * states_.size();
  for (const auto& far : far_) doubles += far.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
