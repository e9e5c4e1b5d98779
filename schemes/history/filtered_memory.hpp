// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/running_sum.hpp"

namespace fde {

// The memory term of components that share a table whose weights w are the Grunwald-Letnikov weights b
// convolved with a filter phi,
//   sum_{j<n} w(n-j) x_j = sum_{j<n} b(n-j) z_j + sum_{i>=1} phi_i x_(n-i),   z_j = sum_{i>=0} phi_i x_(j-i).
// The last sum is z_n - x_n. x_0 has no weight of its own.
class FilteredMemory {
 public:
  // For at most `steps` steps.
  FilteredMemory(const WeightTable& table, Eigen::Index components, int steps, double tolerance);

  // Appends x_0, x_1, ..., one value a component.
  void push(In sample);

  // The sum after x_0 ... x_(n-1) have been pushed, for one component.
  [[nodiscard]] double convolved(Eigen::Index component) const {
    return (memory_ ? memory_->convolved(0)[component] : totals_[component]) + tail_[component];
  }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive);

 private:
  bool running_sums_;
  Vec filter_;           // phi_L, ..., phi_2, padded with zeros to a whole number of vectors
  double first_;         // phi_1, separate: a vector load of its just stored sample would stall
  Matrix window_;        // the newest samples, one column a component, 2 filter_.size() + 1 rows
  Eigen::Index next_;    // row of the next sample
  Vec tail_, filtered_;  // sum_{i>=1} phi_i x_(n-i); z_n
  RunningSums totals_;   // of z_0, z_1, ...
  std::optional<ExponentialMemory> memory_;  // nullopt at order 1
};

}  // namespace fde
