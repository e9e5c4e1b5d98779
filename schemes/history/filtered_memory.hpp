#pragma once

#include <optional>

#include "history/exponential_memory.hpp"
#include "history/running_sum.hpp"

namespace fde {

// The past of components that share a table whose weights are those of grunwald_letnikov behind a filter,
//   sum_{j<n} w(n-j) x_j = sum_{j<n} b(n-j) z_j + sum_{i>=1} phi_i x_(n-i),   z_j = sum_{i>=0} phi_i x_(j-i),
// b the weights of grunwald_letnikov. The last sum is what z_n has besides x_n. x_0 is a sample as any other.
class FilteredMemory {
 public:
  // For lags up to the longest.
  FilteredMemory(const WeightTable& table, Eigen::Index components, double longest, double tolerance);

  // Appends x_0, x_1, ..., one value a component.
  void push(In sample);

  // The sum after x_0 ... x_(n-1), for one component.
  [[nodiscard]] double convolved(Eigen::Index component) const {
    return (memory_ ? memory_->convolved(0)[component] : totals_[component]) + tail_[component];
  }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive);

 private:
  bool running_sums_;
  Vec filter_;           // phi_L, ..., phi_2, to a whole number of vectors
  double first_;         // phi_1, apart: its sample is too new to be read in a vector
  Matrix window_;        // the newest samples, one column a component, twice as long as the filter and one
  Eigen::Index next_;    // row of the next sample
  Vec tail_, filtered_;  // sum_{i>=1} phi_i x_(n-i); z_n
  RunningSums totals_;   // of z_0, z_1, ...
  std::optional<ExponentialMemory> memory_;  // none at order 1
};

}  // namespace fde
