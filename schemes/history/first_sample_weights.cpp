// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/first_sample_weights.hpp"

#include <cmath>

namespace fde {
namespace {

// The weights of x_0 at the steps first, first + 1, ... of a block, up to the step `last`.
Vec exact_start(const WeightTable& table, Eigen::Index first, Eigen::Index last) {
  return Vec::NullaryExpr(MemoryTables::block, [&](Eigen::Index k) {
    if (first + k > last) return 0.0;
    const auto own = first_sample_weight(table, first + k);
    return own ? *own : weight(table, first + k);
  });
}

}  // namespace

// x_0 is the newest sample before the first block. Later samples are 0; their running sums remain 1.
FirstSampleWeights::FirstSampleWeights(const std::vector<WeightTable>& weights, const MemoryTables& tables)
    : exact_(block * tables.count),
      factors_(Matrix::Zero(tables.compressed.nodes.size(), tables.count)),
      weighted_(factors_),
      active_(tables.nodes.size()),
      states_(Vec::Zero(tables.nodes.size())),
      carries_(states_),
      input_(states_),
      later_(states_),
      condensed_(tables.points()) {
  const bool running_sums = acts_on_running_sums(weights.front());
  const auto nodes = tables.nodes.tail(tables.exponentials).array();
  const auto decay = [&](Eigen::Index age) -> Vec { return (-double(age) * nodes).exp(); };
  input_.tail(nodes.size()) = decay(block - recent);
  for (Eigen::Index age = 0; running_sums && age < block; ++age) {
    later_.tail(nodes.size()) += decay(age);
    if (age < block - recent) input_.tail(nodes.size()) += decay(age);
  }
  if (running_sums) near_.setZero(exact_.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto table = static_cast<Eigen::Index>(i);
    exact_.segment(table * block, block) = exact_start(weights[i], 1, tables.longest);
    const auto start = first_sample_weight(weights[i], 1);
    if (start && *start == 0.0) continue;
    factors_.col(table) = start ? first_sample_coefficients(weights[i], tables.compressed)
                                : weight_coefficients(weights[i], tables.compressed);
    if (running_sums) near_.segment(table * block, block) = exact_start(weights[i], recent, tables.longest);
  }
}

void FirstSampleWeights::advance_block(const MemoryTables& tables) {
  exact_ = near_;
  advance_states(active_, 1, tables.decay_minus_one.data(), input_, states_, carries_);
  input_ = later_;
  drop_negligible_states(tables.slow);
  const auto points = tables.points(), slow = tables.slow;
  condensed_.setZero();
  multiply_add(points, slow, 1, tables.condense, states_, condensed_);
  for (Eigen::Index table = 0; table < factors_.cols(); ++table) {
    weighted_.col(table).head(points) = factors_.col(table).head(points).cwiseProduct(condensed_);
    weighted_.col(table).tail(states_.size() - slow) =
        factors_.col(table).tail(states_.size() - slow).cwiseProduct(states_.tail(states_.size() - slow));
  }
}

// Drops states that are far below the rounding of any weight, before they become subnormal and slow.
void FirstSampleWeights::drop_negligible_states(Eigen::Index slow) {
  constexpr double nothing = 1e-60;
  while (active_ > slow && later_[active_ - 1] == 0.0 &&
         states_.segment(active_ - lanes, lanes).maxCoeff() < nothing) {
    active_ -= lanes;
    states_.segment(active_, lanes).setZero();
  }
}

std::size_t FirstSampleWeights::bytes() const {
  const auto doubles =
      exact_.size() + near_.size() + 2 * factors_.size() + 4 * states_.size() + condensed_.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
