// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "fdebench/schemes/history/memory_tables.hpp"
#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// The states and sums of an ExponentialMemory with many components: loops are vectorised over components and
// access memory sequentially. The states of `tile` components are contiguous, so that a block advances them
// in the cache and reads them from memory once in 32 steps. Terms are added in the order of NarrowMemory: the
// results have the same bits. The threads of RowThreads share the components.
class WideMemory {
 public:
  static constexpr Eigen::Index tile = 64, strip = 512;

  WideMemory(const MemoryTables& tables, Eigen::Index components);

  // Appends x_0, before the first push. `start` has its weights in the first block.
  void begin(In first, const FirstSampleWeights& start);

  // Appends the sample at this step of a block. At the last step `start` has the weights of x_0 in the next
  // block.
  void push(const MemoryTables& tables, Eigen::Index position, In sample, const FirstSampleWeights& start);

  // Writes the sums of a table at the next step to result, one value a component.
  void convolve(Eigen::Index table, Eigen::Index position, double* result) const;

  // The same in components() contiguous values. They are computed in the first call after a push.
  [[nodiscard]] const double* sums(Eigen::Index table, Eigen::Index position) const;
  static constexpr Eigen::Index stride() { return 1; }
  [[nodiscard]] Eigen::Index components() const { return components_; }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(first_, samples_, sums_, states_, carries_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  // Work space of a tile, one row a component. Columns: points and other nodes; slow nodes; points; points
  // and other nodes.
  struct Scratch {
    Matrix gathered, input, condensed, weighted;
  };

  // The rows from `first` on of a column of samples_ or sums_, and the distance to the next column.
  [[nodiscard]] ConstBlock rows_of(const Matrix& all, Eigen::Index column, Eigen::Index first) const;
  Block rows_of(Matrix& all, Eigen::Index column, Eigen::Index first) const;
  // The following functions are for the `count` rows of the tile from `first` on.
  void add_exact(const FirstSampleWeights& start, Eigen::Index first, Eigen::Index count);
  void add_recent(Eigen::Index position, Eigen::Index first, Eigen::Index count);
  void advance_tile(const MemoryTables& tables, const FirstSampleWeights& start, Eigen::Index first,
                    Eigen::Index count, Scratch& scratch);
  [[nodiscard]] Eigen::Index rows_in_tile(Eigen::Index first) const;

  Eigen::Index components_, tables_;
  // The transposed matrices of MemoryTables, without padding nodes.
  Matrix gather_, spread_, condense_, inner_, near_, far_;
  // Rows are components, padded to a multiple of lanes. samples_ and sums_ have one column a strip: the rows
  // of the strip of each of their columns, one after the other with the distance pitch_. It is no multiple of
  // a page, so that the columns of a tile do not share the same sets of the cache.
  Eigen::Index pitch_;
  Vec first_;                                   // x_0; 0 before begin()
  Matrix samples_;                              // (recent + block) columns
  Matrix sums_;                                 // (block per table) columns, without the newest samples
  Matrix states_, carries_;                     // one column a tile: exponentials columns
  mutable Matrix current_;                      // components x tables: the sums of the next step
  mutable std::vector<bool> current_is_known_;  // of each table
};

}  // namespace fde
