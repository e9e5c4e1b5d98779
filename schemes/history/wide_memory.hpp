// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "fdebench/schemes/history/first_sample_weights.hpp"
#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// The states and sums of an ExponentialMemory with many components: loops are vectorised over components and
// access memory sequentially. The states of `tile` components are contiguous, so that a block advances them
// in the cache and reads them from memory once in 32 steps. Terms are added in the order of NarrowMemory: the
// results have the same bits.
class WideMemory {
 public:
  static constexpr Eigen::Index tile = 64;

  // Each step is shared among `threads` threads.
  WideMemory(const MemoryTables& tables, Eigen::Index components, int threads);

  // Appends x_0, before the first push. `start` has its weights in the first block.
  void begin(In first, const FirstSampleWeights& start);

  // Appends the sample at this step of a block. At the last step `start` has the weights of x_0 in the next
  // block.
  void push(const MemoryTables& tables, Eigen::Index position, In sample, const FirstSampleWeights& start);

  // The sums of a table at the next step, components() contiguous values.
  [[nodiscard]] const double* sums(Eigen::Index table, Eigen::Index /*position*/) const {
    return current_.col(table).data();
  }
  // Writes them to result.
  void convolve(Eigen::Index table, Eigen::Index position, double* result) const {
    std::copy_n(sums(table, position), components_, result);
  }
  static constexpr Eigen::Index stride() { return 1; }
  [[nodiscard]] Eigen::Index components() const { return components_; }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(first_, samples_, sums_, current_, states_, carries_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  // Work space of a tile, one row a component. Columns: points and other nodes; slow nodes; points; points
  // and other nodes.
  struct Scratch {
    Matrix gathered, input, condensed, weighted;
  };

  // push() for `count` rows from `first` on: a whole number of tiles, except at the end.
  void push_part(const MemoryTables& tables, Eigen::Index position, In sample,
                 const FirstSampleWeights& start, Eigen::Index first, Eigen::Index count);
  void add_exact(const FirstSampleWeights& start, Eigen::Index first, Eigen::Index count);
  void add_recent(Eigen::Index position, Eigen::Index first, Eigen::Index count, Eigen::Index tables);
  void advance_tile(const MemoryTables& tables, const FirstSampleWeights& start, Eigen::Index first,
                    Eigen::Index count, Scratch& scratch);
  void complete_sums(Eigen::Index position, Eigen::Index first, Eigen::Index count, Eigen::Index tables);

  Eigen::Index components_;
  int threads_;
  // The transposed matrices of MemoryTables, without padding nodes.
  Matrix gather_, spread_, condense_, inner_, near_, far_;
  // Rows are components, padded to a multiple of lanes.
  Vec first_;                // x_0; 0 before begin()
  Matrix samples_;           // components x (recent + block)
  Matrix sums_;              // components x (block per table), without the newest samples
  Matrix current_;           // components x tables: the sums of the next step
  Matrix states_, carries_;  // one column a tile: a tile x exponentials matrix, stacked by columns
};

}  // namespace fde
