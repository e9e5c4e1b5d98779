// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/weights/weight_transform.hpp"

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

}  // namespace fde
