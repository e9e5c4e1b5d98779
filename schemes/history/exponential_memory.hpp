// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "fdebench/schemes/history/first_sample_weights.hpp"
#include "fdebench/schemes/history/narrow_memory.hpp"
#include "fdebench/schemes/history/wide_memory.hpp"

namespace fde {

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
