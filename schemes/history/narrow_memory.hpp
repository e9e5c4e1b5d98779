// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/first_sample_weights.hpp"
#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/componentwise.hpp"

namespace fde {

// The states and sums of an ExponentialMemory with few components: one column a component; loops are
// vectorised over the steps of a block or over the exponentials.
class NarrowMemory {
 public:
  NarrowMemory(const MemoryTables& tables, Eigen::Index components);

  // Appends x_0, before the first push. `start` has its weights in the first block.
  void begin(In first, const FirstSampleWeights& start);

  // Appends the sample at this step of a block. At the last step `start` has the weights of x_0 in the next
  // block.
  void push(const MemoryTables& tables, Eigen::Index position, In sample, const FirstSampleWeights& start);

  // The sums of a table at the next step, components() values with the distance stride().
  [[nodiscard]] const double* sums(Eigen::Index table, Eigen::Index position) const {
    return sums_.data() + table * block + position;
  }
  // Writes them to result, one after the other.
  void convolve(Eigen::Index table, Eigen::Index position, double* result) const {
    for_each_component(components(), [=, values = sums(table, position), stride = stride()](Eigen::Index i) {
      result[i] = values[i * stride];
    });
  }
  [[nodiscard]] Eigen::Index stride() const { return sums_.rows(); }
  [[nodiscard]] Eigen::Index components() const { return sums_.cols(); }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive) { archive(first_, samples_, states_, carries_, sums_); }

 private:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  // The work after the last step of a group of `recent`. Not inlined: most steps need none of it.
  [[gnu::noinline]] void end_group(const MemoryTables& tables, Eigen::Index next,
                                   const FirstSampleWeights& start);
  void add_recent(const MemoryTables& tables, Eigen::Index position);
  void advance_block(const MemoryTables& tables, const FirstSampleWeights& start);
  void add_exact(const FirstSampleWeights& start);

  Vec first_;                        // x_0; 0 before begin()
  Matrix samples_;                   // (recent + block) x components
  Matrix gathered_;                  // (points and other nodes) x components
  Matrix states_, carries_, input_;  // nodes x components
  Matrix condensed_;                 // points x components
  Matrix weighted_;                  // (points and other nodes) x (tables per component)
  Matrix sums_;                      // (block per table) x components
};

}  // namespace fde
