// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/memory_tables.hpp"
#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

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
