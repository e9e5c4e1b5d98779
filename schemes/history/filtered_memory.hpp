// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde {

// The memory term of components that share a table whose weights w are the Grunwald-Letnikov weights b
// convolved with a filter phi,
//   sum_{j<n} w(n-j) x_j = sum_{j<n} b(n-j) z_j + sum_{i>=1} phi_i x_(n-i),   z_j = sum_{i>=0} phi_i x_(j-i).
// The last sum, the tail, is z_n - x_n: each sample is added to the tails of all later steps when it is
// pushed. x_0 has no weight of its own.
class FilteredMemory {
 public:
  // For at most `steps` steps.
  FilteredMemory(const WeightTable& table, Eigen::Index components, int steps, double tolerance);

  // Appends x_0, x_1, ..., one value a component.
  void push(In sample);

  // The sum after x_0 ... x_(n-1) have been pushed, for one component.
  [[nodiscard]] double convolved(Eigen::Index component) const {
    return (memory_ ? memory_->convolved(0)[component] : totals_[component]) + tails_(position_, component);
  }

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive);

 private:
  bool running_sums_;
  Matrix filter_;  // column p: phi_(k-p), k = 0, 1, ..., or 0 where there is none
  Matrix tails_;   // row k: the tail at step k of this group of `lanes` steps, as far as known; more rows
  Eigen::Index position_ = 0;                // of the next sample in its group
  Vec filtered_;                             // z_n
  RunningSums totals_;                       // of z_0, z_1, ...
  std::optional<ExponentialMemory> memory_;  // nullopt at order 1
};

// The sums of a FilteredMemory for many components. The generating function of the weights has its
// singularity at 1 and others that decay: from the lag `exact_lags` on the weights are, up to rounding, those
// of the singularity at 1, sums of exponentials whose coefficients are those of the Grunwald-Letnikov weights
// times the other factor of the generating function. Samples with smaller lags enter with their exact
// weights.
//
// Sums are computed a block of steps at a time, with loops over components; a tile of components, whose
// samples are contiguous, stays in the cache. Until the sample of a step is known its place has the sum of
// the step. Work and memory do not grow with the number of steps. The threads of RowThreads share the
// components.
class WideFilteredMemory {
 public:
  // For at most `steps` steps.
  WideFilteredMemory(const WeightTable& table, Eigen::Index components, int steps, double tolerance);

  // Appends x_0, x_1, ..., one value a component.
  void push(In sample);

  // sum_{j<n} w(n-j) x_j after x_0 ... x_(n-1) have been pushed, for one component.
  [[nodiscard]] double convolved(Eigen::Index component) const { return current_[component]; }

  // The lag, a multiple of block, up to which weights are exact: where the other singularities have decayed
  // below rounding, or the first multiple that is not below `longest`.
  static Eigen::Index exact_lags(const MultistepRule& rule, double longest);

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive);

 private:
  static constexpr Eigen::Index tile = 64, block = 32, group = lanes;

  void set_exponentials(const WeightTable& table, double longest, double tolerance);
  // push() for the tile from row `first` on; next: the position of the next sample in its block.
  void push_tile(In sample, Eigen::Index first, Eigen::Index next);
  // Moves the oldest block of samples to the states, and puts the sums of the next steps in its place.
  void advance_tile(Eigen::Index first);
  [[nodiscard]] Block columns(Eigen::Index first, Eigen::Index column) {
    return {samples_.col(first / tile).data() + column * tile, tile};
  }

  Eigen::Index components_, exact_lags_;  // a multiple of block
  Matrix near_;   // exact_lags x block: w(exact_lags + column - row), of the samples before a block
  Matrix inner_;  // group x group: w(column - row), 0 where row >= column
  Vec decay_minus_one_, factors_;  // exp(-node block) - 1, and the coefficient of each exponential
  Matrix gather_, far_;            // block x nodes: exp(-node (block-1-row)); nodes x block, of later steps
  // One column a tile: its samples, a column of the tile for each, in a ring; the states of the exponentials
  // and the carries of their compensated sums.
  Matrix samples_, states_, carries_;
  Eigen::Index begin_ = 0, position_ = 0;  // the column of this block, and the next sample in it
  Vec current_;                            // the sums of the next step
  std::optional<RunningSums> totals_;      // for orders above 1: the samples are running sums
};

}  // namespace fde
