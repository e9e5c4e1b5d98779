#pragma once

#include <vector>

#include "checkpoint/archive.hpp"
#include "history/memory_tables.hpp"

namespace fde {

// The weights of x_0 at each step, of every table: a sample as any other, x_0 = 1, with states of its own.
class MemoryStart {
 public:
  MemoryStart(const std::vector<WeightTable>& weights, const MemoryTables& tables);

  // Goes to the next block.
  void advance_block(const MemoryTables& tables);

  // The weights at the steps of a block are MemoryTables::far times these, one column a table, and besides
  // those that are known exactly, block of each table. In the first block that is all of them.
  [[nodiscard]] const Matrix& weighted() const { return weighted_; }
  [[nodiscard]] const Vec& exact() const { return exact_; }

  // Whether there are exact ones from the second block on.
  [[nodiscard]] bool stays_exact() const { return near_.size() > 0; }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) {
    archive.grown(exact_);
    archive(weighted_, states_, carries_, input_);
    archive.count(alive_, 0, states_.size());
  }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  void leave_out_what_decayed(Eigen::Index slow);

  Vec exact_, near_;    // block of each table: those of this block, and of all after the first
  Matrix factors_;      // as those of the tables; 0 where weights are
  Matrix weighted_;     // factors_, times the states
  Eigen::Index alive_;  // so many nodes, the slowest, have states that count; a multiple of lanes
  Vec states_, carries_, input_, later_, joined_;
};

}  // namespace fde
