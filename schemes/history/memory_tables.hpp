// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/weights/exponential_sum.hpp"
#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// The matrices with which an ExponentialMemory advances and evaluates a block of steps. The rows of several
// weight tables are stacked.
//
// For the short times within a block the slow exponentials are interpolated in s, exp(-s t) = sum_i L_i(s)
// exp(-sigma_i t), with the Lagrange polynomials of eight Chebyshev points sigma_i. So eight exponentials
// replace all slow ones in `gather` and `far`. docs/history.md has the error bound.
struct MemoryTables {
  static constexpr Eigen::Index block = 32, recent = lanes;

  // For lags up to `longest_lag`. In runs shorter than a block the sum has no nodes. Precondition: all tables
  // have the same kernel exponent, and all or none of them weigh running sums.
  MemoryTables(const std::vector<WeightTable>& tables, const ExponentialSum& sum,
               Eigen::Index longest_lag = block + recent);

  Eigen::Index count, exponentials;  // number of tables; number of nodes without padding
  Eigen::Index longest;              // weights of longer lags are 0
  Vec nodes;                         // increasing, padded in front with 0 to a multiple of lanes
  Eigen::Index slow;                 // number of first nodes that are interpolated, a multiple of lanes or 0
  ExponentialSum compressed;         // the points sigma_i, with coefficient 1, and the other nodes
  Vec decay_minus_one;               // exp(-nodes block) - 1
  Matrix gather;    // (points and other nodes) x block: the contribution of each sample of a block
  Matrix spread;    // slow nodes x points: L_i(s_m)
  Matrix condense;  // points x slow nodes: c_m L_i(s_m)
  Matrix inner;     // (recent per table) x recent: w(row - column), 0 where row <= column
  Matrix near;      // (block per table) x recent: w(recent + row - column)
  Matrix far;       // block x (points and other nodes): exp(-node (recent + 1 + row)), for all tables
  Matrix factors;   // (points and other nodes) x count: the coefficients of each table

  // Number of points sigma_i.
  [[nodiscard]] Eigen::Index points() const { return spread.cols(); }

 private:
  void interpolate_slow(const ExponentialSum& sum);
  void fill(const WeightTable& weights, Eigen::Index table);
};

// The weights of x_0 at each step, for every table: the contribution of a sample x_0 = 1, which has separate
// states because its weights may differ from w(n).
class FirstSampleWeights {
 public:
  FirstSampleWeights(const std::vector<WeightTable>& weights, const MemoryTables& tables);

  // Advances to the next block.
  void advance_block(const MemoryTables& tables);

  // The weights at the steps of a block are MemoryTables::far * weighted(), one column a table, plus exact(),
  // `block` entries a table. In the first block weighted() is 0.
  [[nodiscard]] const Matrix& weighted() const { return weighted_; }
  [[nodiscard]] const Vec& exact() const { return exact_; }

  // Whether exact() is nonzero from the second block on.
  [[nodiscard]] bool has_exact_after_first_block() const { return near_.size() > 0; }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) {
    archive.resizable(exact_);
    archive(weighted_, states_, carries_, input_);
    archive.count(active_, 0, states_.size());
  }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  void drop_negligible_states(Eigen::Index slow);

  Vec exact_, near_;     // block entries a table: exact() of this block, and of all blocks after the first
  Matrix factors_;       // as MemoryTables::factors; a column is 0 where x_0 has no weight
  Matrix weighted_;      // factors_ times the states
  Eigen::Index active_;  // number of slowest nodes whose states are not negligible; a multiple of lanes
  Vec states_, carries_, input_, later_, condensed_;
};

}  // namespace fde
