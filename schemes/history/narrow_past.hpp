#pragma once

#include "checkpoint/archive.hpp"
#include "history/memory_start.hpp"

namespace fde {

// The past of a few components: a component is a column, and what is done at once is done with the steps of a
// block, or with the exponentials.
class NarrowPast {
 public:
  NarrowPast(const MemoryTables& tables, Eigen::Index components);

  // Takes x_0, before the first push. The start tells its weights in the first block.
  void begin(In first, const MemoryStart& start);

  // Takes the sample at this step of a block. At the end of a block the start tells those of the next.
  void push(const MemoryTables& tables, Eigen::Index position, In sample, const MemoryStart& start);

  // The sums of a table at the step that follows; stride between components.
  [[nodiscard]] const double* sums(Eigen::Index table, Eigen::Index position) const {
    return &sums_(table * MemoryTables::block + position, 0);
  }
  [[nodiscard]] Eigen::Index stride() const { return sums_.rows(); }
  [[nodiscard]] Eigen::Index components() const { return sums_.cols(); }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(first_, samples_, states_, carries_, sums_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  void pass_on(const MemoryTables& tables, Eigen::Index position);
  void advance_block(const MemoryTables& tables, const MemoryStart& start);
  void add_exact(const MemoryStart& start);

  Vec first_;                        // x_0; 0 where it has no weights of its own
  Matrix samples_;                   // (recent + block) x components
  Matrix gathered_;                  // (points and other nodes) x components
  Matrix states_, carries_, input_;  // nodes x components
  Matrix joined_;                    // points x components
  Matrix weighted_;                  // (points and other nodes) x tables of each component: to be evaluated
  Matrix sums_;                      // block x components of each table
};

}  // namespace fde
