// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/memory_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fde {

namespace {

using Real = long double;

// Interpolation of exp(-s t) in s at n Chebyshev points of [0, S] has an error of at most 2 (S t / 4)^n / n!:
// 1.2e-17 for n = lanes and S t up to this value.
constexpr double straight = 0.105;

// The largest node that is interpolated: the lags of a block go up to recent + block.
constexpr double largest_joined = straight / (MemoryTables::recent + MemoryTables::block);

// w(1), w(2), ..., or the differences w(k) - w(k-1) where running sums are weighed.
Vec exact_weights(const WeightTable& table, Eigen::Index count) {
  if (!acts_on_running_sums(table)) return first_weights(table, count);
  return Vec::NullaryExpr(count, [&](Eigen::Index k) { return weight_increment(table, k + 1); });
}

// The values, padded in front with zeros to a multiple of lanes.
Vec filled(const Vec& values) {
  Vec result = Vec::Zero(rounded_up(values.size()));
  result.tail(values.size()) = values;
  return result;
}

// The number of nodes that are interpolated, in whole vectors. For two vectors the gain is negligible.
Eigen::Index joined(const Vec& nodes) {
  const auto above = std::ranges::count_if(nodes, [](double node) { return node > largest_joined; });
  const auto slow = nodes.size() - rounded_up(above);
  return slow > 2 * lanes ? slow : 0;
}

// The Chebyshev points of [0, end].
Vec chebyshev_points(double end) {
  return Vec::NullaryExpr(lanes, [=](Eigen::Index i) {
    const double angle = (static_cast<double>(i) + 0.5) * std::numbers::pi / lanes;
    return 0.5 * end * (1.0 - std::cos(angle));
  });
}

// L_i(node) of these points, one row a node.
Matrix lagrange(const Vec& nodes, const Vec& points) {
  Matrix values(nodes.size(), points.size());
  for (Eigen::Index m = 0; m < nodes.size(); ++m) {
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      Real product = 1;
      for (Eigen::Index k = 0; k < points.size(); ++k) {
        if (k != i) product *= (Real{nodes[m]} - points[k]) / (Real{points[i]} - points[k]);
      }
      values(m, i) = static_cast<double>(product);
    }
  }
  return values;
}

// The weights of x_0 at the steps first, first + 1, ... of a block, up to the step `last`.
Vec exact_start(const WeightTable& table, Eigen::Index first, Eigen::Index last) {
  return Vec::NullaryExpr(MemoryTables::block, [&](Eigen::Index k) {
    if (first + k > last) return 0.0;
    const auto own = first_sample_weight(table, first + k);
    return own ? *own : weight(table, first + k);
  });
}

}  // namespace

MemoryTables::MemoryTables(const std::vector<WeightTable>& tables, const ExponentialSum& sum,
                           Eigen::Index longest_lag)
    : count(std::ssize(tables)),
      exponentials(sum.nodes.size()),
      longest(longest_lag),
      nodes(filled(sum.nodes)),
      slow(joined(nodes)),
      compressed(sum) {
  decay_minus_one = (-double{block} * nodes).array().expm1();
  if (slow > 0) interpolate_slow(sum);
  if (slow == 0) compressed = {nodes, filled(sum.coefficients), sum.bound};
  const auto own = slow > 0 ? compressed.nodes.size() : exponentials;
  gather.setZero(compressed.nodes.size(), block);
  for (Eigen::Index k = 0; k < block; ++k)
    gather.col(k).tail(own) = (-double(block - 1 - k) * compressed.nodes.tail(own)).array().exp();
  inner.setZero(count * recent, recent);
  near.resize(count * block, recent);
  far.resize(block, compressed.nodes.size());
  for (Eigen::Index row = 0; row < block; ++row)
    far.row(row) = (-double(recent + 1 + row) * compressed.nodes).array().exp();
  factors.resize(compressed.nodes.size(), count);
  for (Eigen::Index table = 0; table < count; ++table) fill(tables[static_cast<std::size_t>(table)], table);
}

void MemoryTables::interpolate_slow(const ExponentialSum& sum) {
  const Vec points = chebyshev_points(nodes[slow - 1]), coefficients = filled(sum.coefficients);
  const auto others = nodes.size() - slow, fillers = nodes.size() - exponentials;
  compressed.nodes.resize(lanes + others);
  compressed.nodes << points, nodes.tail(others);
  compressed.coefficients.resize(lanes + others);
  compressed.coefficients << Vec::Ones(lanes), coefficients.tail(others);
  spread = lagrange(nodes.head(slow), points);
  spread.topRows(fillers).setZero();
  condense = spread.transpose() * coefficients.head(slow).asDiagonal();
}

void MemoryTables::fill(const WeightTable& weights, Eigen::Index table) {
  Vec exact = Vec::Zero(block + recent - 1);
  const Eigen::Index known = std::min(longest, exact.size());
  exact.head(known) = exact_weights(weights, known);
  for (Eigen::Index k = 0; k < recent; ++k) {
    const auto shorter = recent - 1 - k;
    inner.block((table + 1) * recent - shorter, k, shorter, 1) = exact.head(shorter);
    near.block(table * block, k, block, 1) = exact.segment(shorter, block);
  }
  factors.col(table) = weight_coefficients(weights, compressed);
}

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
