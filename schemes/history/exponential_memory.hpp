// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "fdebench/schemes/history/memory_tables.hpp"
#include "fdebench/schemes/history/wide_memory.hpp"
#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

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

// The memory term of components that share one sum of exponentials, on equal steps, a block of steps at a
// time. Samples that are at least `recent` steps old when a block starts enter through the states
// z_m = sum_j exp(-nodes[m] age_j) x_j, which are advanced and evaluated once a block as small dense
// products; newer samples enter with their exact weights. Work a step and memory do not depend on the number
// of steps. Derivation: docs/history.md.
class ExponentialMemory {
 public:
  static constexpr Eigen::Index block = MemoryTables::block, recent = MemoryTables::recent;

  // The sum of exponentials must be valid for times in [shortest_lag, steps + 2].
  static constexpr double shortest_lag = recent - 1;

  // From this number of components on WideMemory is faster than NarrowMemory. Measured by fde_histories.
  static constexpr Eigen::Index fewest_wide = 64;

  // For at most `steps` steps, with the relative error `tolerance` of each weight. Precondition: all tables
  // have the same kernel exponent, and all or none of them weigh running sums.
  ExponentialMemory(const std::vector<WeightTable>& tables, Eigen::Index components, int steps,
                    double tolerance);

  // Whether a run of so many steps needs exponentials: it completes a block.
  static constexpr bool needs_exponentials(Eigen::Index steps) { return steps >= block; }

  // Appends x_0. Only needed for tables in which x_0 has a weight.
  void begin(In first);

  // Appends x_n, n >= 1, one value a component.
  void push(In sample);

  // first_sample_weight(n) x_0 + sum_{1<=j<n} w(n-j) x_j with the weights of tables[table], after x_1 ...
  // x_(n-1). One value a component.
  using Sums = Eigen::Map<const Vec, 0, Eigen::InnerStride<>>;
  [[nodiscard]] Sums convolved(Eigen::Index table) const {
    return std::visit(
        [&](const auto& memory) {
          return Sums(memory.sums(table, position_), memory.components(),
                      Eigen::InnerStride<>(memory.stride()));
        },
        memory_);
  }

  // The same, written to `result`, an array: a view that is passed on by value is copied by one load of its
  // two members just after they have been stored, which stalls the processor.
  void convolve(Eigen::Index table, double* result) const {
    if (const auto* narrow = std::get_if<NarrowMemory>(&memory_)) {
      narrow->convolve(table, position_, result);
    } else {
      std::get<WideMemory>(memory_).convolve(table, position_, result);
    }
  }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive);

 private:
  MemoryTables tables_;
  FirstSampleWeights start_;
  std::variant<NarrowMemory, WideMemory> memory_;
  Eigen::Index position_ = 0;  // of the next sample in its block
};

}  // namespace fde
