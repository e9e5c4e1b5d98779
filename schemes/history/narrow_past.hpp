#pragma once

#include "checkpoint/archive.hpp"
#include "history/memory_tables.hpp"

namespace fde {

// The past of a few components: a component is a column, and what is done at once is done with the steps of a
// block, or with the exponentials.
class NarrowPast {
 public:
  NarrowPast(const MemoryTables& tables, Eigen::Index components);

  // Takes the sample at this step of a block.
  void push(const MemoryTables& tables, Eigen::Index position, In sample);

  // The sums of a table at the step that follows; stride between components.
  [[nodiscard]] const double* sums(Eigen::Index table, Eigen::Index position) const {
    return &sums_(table * MemoryTables::block + position, 0);
  }
  [[nodiscard]] Eigen::Index stride() const { return sums_.rows(); }
  [[nodiscard]] Eigen::Index components() const { return sums_.cols(); }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(samples_, states_, carries_, sums_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  void pass_on(const MemoryTables& tables, Eigen::Index position);
  void advance_block(const MemoryTables& tables);

  Matrix samples_;                   // (recent + block) x components
  Matrix states_, carries_, input_;  // nodes x components
  Matrix sums_;                      // block x components of each table
};

}  // namespace fde
