#pragma once

#include <vector>

#include "history/block_kernels.hpp"
#include "weights/weight_transform.hpp"

namespace fde {

// The weights with which an ExponentialMemory sums a block of steps. Those of several tables stand below each
// other.
struct MemoryTables {
  static constexpr Eigen::Index block = 32, recent = lanes;

  // Tables of one kernel exponent that all weigh running sums, or all the samples themselves.
  MemoryTables(const std::vector<WeightTable>& tables, const ExponentialSum& sum);

  Eigen::Index count, exponentials;  // of tables; of nodes that are not only there to fill a vector
  Vec nodes;                         // a multiple of lanes, the last ones 0
  Vec decay_minus_one;               // exp(-nodes block) - 1
  Matrix gather;                     // nodes x block: what each sample of a block adds to the states
  Matrix inner;                      // recent x recent of each: w(row - column), 0 where row <= column
  Matrix near;                       // block x recent of each: w(recent + row - column)
  Matrix far;                        // block x nodes of each: c_m exp(-nodes[m] (recent + 1 + row))

 private:
  void fill(const WeightTable& weights, Eigen::Index table, const ExponentialSum& sum);
};

}  // namespace fde
