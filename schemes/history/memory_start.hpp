#pragma once

#include "checkpoint/archive.hpp"
#include "history/memory_tables.hpp"

namespace fde {

// The weights of x_0 at each step, of every table: a sample as any other, x_0 = 1, with states of its own.
class MemoryStart {
 public:
  MemoryStart(const std::vector<WeightTable>& weights, const MemoryTables& tables, const ExponentialSum& sum);

  // That of a table at a step of this block.
  [[nodiscard]] double at(Eigen::Index position, Eigen::Index table) const {
    return weights_(position, table);
  }

  void advance_block(const MemoryTables& tables);

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(weights_, states_, carries_, input_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  Matrix weights_, near_;    // block x tables: those of this block, and their exact part
  std::vector<Matrix> far_;  // block x nodes of each; empty where the weights are 0
  Vec states_, carries_, input_, later_;
};

}  // namespace fde
