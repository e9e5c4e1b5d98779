#include "history/exponential_memory.hpp"

#include <cmath>

namespace fde {
namespace {

// w(1), w(2), ..., or their differences.
Vec exact_weights(const WeightTable& table, Eigen::Index count) {
  return Vec::NullaryExpr(count, [&](Eigen::Index k) {
    return weighs_running_sums(table) ? weight_increment(table, k + 1) : weight(table, k + 1);
  });
}

// The weights of x_0 at the steps first, first + 1, ...
Vec exact_start(const WeightTable& table, Eigen::Index first, Eigen::Index count) {
  return Vec::NullaryExpr(count, [&](Eigen::Index k) {
    const auto own = start_weight(table, first + k);
    return own ? *own : weight(table, first + k);
  });
}

}  // namespace

ExponentialMemory::ExponentialMemory(const std::vector<WeightTable>& tables, Eigen::Index components,
                                     const ExponentialSum& sum)
    : running_sums_(weighs_running_sums(tables.front())) {
  const auto count = static_cast<Eigen::Index>(tables.size());
  const Vec nodes = padded(sum.nodes, 0.0);
  decay_minus_one_ = (-double{block} * nodes).array().expm1();
  gather_.setZero(nodes.size(), block);
  for (Eigen::Index k = 0; k < block; ++k) {
    gather_.col(k).head(sum.nodes.size()) = (-double(block - 1 - k) * sum.nodes).array().exp();
  }
  samples_.setZero(recent + block, components);
  states_.setZero(nodes.size(), components);
  carries_ = input_ = states_;

  inner_.setZero(count * recent, recent);
  near_.resize(count * block, recent);
  far_.resize(count * block, nodes.size());
  for (Eigen::Index row = 0; row < block; ++row) {
    far_.row(row) = (-double(recent + 1 + row) * nodes).array().exp();
  }
  for (Eigen::Index table = 1; table < count; ++table)
    far_.middleRows(table * block, block) = far_.topRows(block);
  sums_.setZero(count * block, components);

  start_.resize(block, count);
  start_near_.setZero(block, count);
  start_far_.resize(tables.size());
  start_states_ = start_carries_ = Vec::Zero(nodes.size());
  // x_0 is the newest sample before the first block. Alone it adds nothing later; its running sum stays 1.
  start_later_ = running_sums_ ? Vec(gather_.rowwise().sum()) : Vec(Vec::Zero(nodes.size()));
  start_input_ = gather_.col(recent - 1);
  if (running_sums_) start_input_ += gather_.rightCols(block - recent).rowwise().sum();
  for (Eigen::Index table = 0; table < count; ++table) {
    fill_table(tables[static_cast<std::size_t>(table)], table, sum);
  }
}

void ExponentialMemory::fill_table(const WeightTable& weights, Eigen::Index table,
                                   const ExponentialSum& sum) {
  const Vec exact = exact_weights(weights, block + recent - 1);
  for (Eigen::Index k = 0; k < recent; ++k) {
    const auto shorter = recent - 1 - k;
    inner_.block((table + 1) * recent - shorter, k, shorter, 1) = exact.head(shorter);
    near_.block(table * block, k, block, 1) = exact.segment(shorter, block);
  }
  auto far = far_.middleRows(table * block, block);
  start_.col(table) = exact_start(weights, 1, block);
  const auto start = start_weight(weights, 1);
  if (!start || *start != 0.0) {
    const Vec coefficients = start ? start_coefficients(weights, sum) : weight_coefficients(weights, sum);
    start_far_[static_cast<std::size_t>(table)] = far * padded(coefficients, 0.0).asDiagonal();
    if (running_sums_) start_near_.col(table) = exact_start(weights, recent, block);
  }
  far *= padded(weight_coefficients(weights, sum), 0.0).asDiagonal();
}

void ExponentialMemory::push(In sample) {
  samples_.row(recent + position_) = sample;
  const Eigen::Index column = position_ % recent, first = position_ - column;
  for (Eigen::Index table = 0; table < start_.cols(); ++table) {
    scatter(&inner_(table * recent, column), sample.data(), sums_.cols(),
            {&sums_(table * block + first, 0), sums_.rows()});
  }
  ++position_;
  if (position_ == block) {
    position_ = 0;
    advance_block();
    advance_start();
  } else if (position_ % recent == 0) {
    pass_on();
  }
}

// What the newest `recent` samples add to the rest of the block.
void ExponentialMemory::pass_on() {
  for (Eigen::Index table = 0; table < start_.cols(); ++table) {
    multiply_add(block - position_, recent, sums_.cols(), {&near_(table * block, 0), near_.rows()},
                 {&samples_(position_, 0), samples_.rows()},
                 {&sums_(table * block + position_, 0), sums_.rows()});
  }
}

void ExponentialMemory::advance_block() {
  input_.setZero();
  multiply_add(gather_.rows(), block, input_.cols(), gather_, samples_, input_);
  advance(states_.rows(), states_.cols(), decay_minus_one_.data(), input_, states_, carries_);
  samples_.topRows(recent) = samples_.bottomRows(recent);
  sums_.setZero();
  multiply_add(far_.rows(), far_.cols(), sums_.cols(), far_, states_, sums_);
  pass_on();
}

void ExponentialMemory::advance_start() {
  const auto count = start_states_.size();
  advance(count, 1, decay_minus_one_.data(), start_input_, start_states_, start_carries_);
  start_input_ = start_later_;
  start_ = start_near_;
  for (std::size_t table = 0; table < start_far_.size(); ++table) {
    if (start_far_[table].size() == 0) continue;
    multiply_add(block, count, 1, start_far_[table], start_states_,
                 {&start_(0, static_cast<Eigen::Index>(table)), block});
  }
}

std::size_t ExponentialMemory::bytes() const {
  Eigen::Index doubles = decay_minus_one_.size() + gather_.size() + samples_.size() + 3 * states_.size() +
                         inner_.size() + near_.size() + far_.size() + sums_.size() + 2 * start_.size() +
                         4 * start_states_.size();
  for (const auto& far : start_far_) doubles += far.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
