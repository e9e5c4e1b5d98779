#pragma once

#include <vector>

#include "history/block_kernels.hpp"
#include "weights/weight_transform.hpp"

namespace fde {

// The weights with which an ExponentialMemory sums a block of steps. Those of several tables stand below each
// other.
//
// Within a block the slow exponentials are nearly straight, exp(-s t) = sum_i L_i(s) exp(-sigma_i t) with the
// Lagrange polynomials of eight points sigma_i. So eight exponentials stand for all slow ones where a block
// is gathered and where it is evaluated. docs/history.md has the bound.
struct MemoryTables {
  static constexpr Eigen::Index block = 32, recent = lanes;

  // Tables of one kernel exponent that all weigh running sums, or all the samples themselves.
  MemoryTables(const std::vector<WeightTable>& tables, const ExponentialSum& sum);

  Eigen::Index count, exponentials;  // of tables; of nodes that are not only there to fill a vector
  Vec nodes;                         // increasing, a multiple of lanes; the first ones may be 0 to fill one
  Eigen::Index slow;                 // the first so many are joined, a multiple of lanes; 0: none is
  ExponentialSum together;           // the points sigma_i, each with coefficient 1, and the nodes not joined
  Vec decay_minus_one;               // exp(-nodes block) - 1
  Matrix gather;   // (points and other nodes) x block: what each sample of a block adds to them
  Matrix spread;   // slow nodes x points: L_i(s_m)
  Matrix join;     // points x slow nodes: c_m L_i(s_m)
  Matrix inner;    // recent of each x recent: w(row - column), 0 where row <= column
  Matrix near;     // block of each x recent: w(recent + row - column)
  Matrix far;      // block x (points and other nodes): exp(-node (recent + 1 + row)), for all tables
  Matrix factors;  // (points and other nodes) x count: the coefficients of each table

  // How many points there are.
  [[nodiscard]] Eigen::Index points() const { return spread.cols(); }

 private:
  void join_slow(const ExponentialSum& sum);
  void fill(const WeightTable& weights, Eigen::Index table);
};

}  // namespace fde
