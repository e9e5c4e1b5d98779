#pragma once

#include "checkpoint/archive.hpp"
#include "history/memory_start.hpp"

namespace fde {

// The past of many components: what is done at once is done with neighbours, and every array is read and
// written from its first entry to its last. The states of `tile` components lie together, so that a block
// advances them in the cache, once through memory in 32 steps. Terms are added in the order of NarrowPast:
// the results have the same bits.
class WidePast {
 public:
  static constexpr Eigen::Index tile = 64;

  // Steps are shared among so many threads.
  WidePast(const MemoryTables& tables, Eigen::Index components, int threads);

  // Takes x_0, before the first push. The start tells its weights in the first block.
  void begin(In first, const MemoryStart& start);

  // Takes the sample at this step of a block. At the end of a block the start tells those of the next.
  void push(const MemoryTables& tables, Eigen::Index position, In sample, const MemoryStart& start);

  // The sums of a table at the step that follows.
  [[nodiscard]] const double* sums(Eigen::Index table, Eigen::Index /*position*/) const {
    return current_.col(table).data();
  }
  static constexpr Eigen::Index stride() { return 1; }
  [[nodiscard]] Eigen::Index components() const { return components_; }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(first_, samples_, sums_, current_, states_, carries_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  // What a tile computes on its way, a column each: points and other nodes, slow nodes, points, again all.
  struct Scratch {
    Matrix gathered, input, joined, weighted;
  };

  // What a push does to the rows from `first` on, so many: a whole number of tiles, but for the last.
  void push_part(const MemoryTables& tables, Eigen::Index position, In sample, const MemoryStart& start,
                 Eigen::Index first, Eigen::Index count);
  void add_exact(const MemoryStart& start, Eigen::Index first, Eigen::Index count);
  void pass_on(Eigen::Index position, Eigen::Index first, Eigen::Index count, Eigen::Index tables);
  void advance_tile(const MemoryTables& tables, const MemoryStart& start, Eigen::Index first,
                    Eigen::Index count, Scratch& scratch);
  void take_sums(Eigen::Index position, Eigen::Index first, Eigen::Index count, Eigen::Index tables);

  Eigen::Index components_;
  int threads_;
  // Those of the tables, with rows and columns exchanged, and without nodes that only fill a vector.
  Matrix gather_, spread_, join_, inner_, near_, far_;
  // Rows are components, filled up to a multiple of lanes.
  Vec first_;                // x_0; 0 where it has no weights of its own
  Matrix samples_;           // components x (recent + block)
  Matrix sums_;              // components x block of each table, without the newest samples
  Matrix current_;           // components x tables: the sums of the step that follows
  Matrix states_, carries_;  // tile x exponentials of a tile below each other, a column a tile
};

}  // namespace fde
