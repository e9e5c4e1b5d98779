#pragma once

#include <vector>

#include "history/block_kernels.hpp"
#include "weights/weight_transform.hpp"

namespace fde {

// The past of components that share one sum of exponentials, on a uniform grid, a block of steps at a time.
// Samples at least `recent` steps old when a block starts live in states z_m = sum_j exp(-nodes[m] age_j)
// x_j, advanced and evaluated once a block as small dense products; the others enter through their exact
// weights. Work a step and memory do not depend on the number of steps done. docs/history.md derives it.
class ExponentialMemory {
 public:
  static constexpr Eigen::Index block = 32, recent = lanes;

  // The sum of exponentials must hold for times in [shortest_lag, steps + 2].
  static constexpr double shortest_lag = recent - 1;

  // Tables of one kernel exponent that all weigh running sums, or all the samples themselves.
  ExponentialMemory(const std::vector<WeightTable>& tables, Eigen::Index components,
                    const ExponentialSum& sum);

  // Appends x_n, n >= 1, one value a component.
  void push(In sample);

  // sum_{1<=j<n} w(n-j) x_j with the weights of tables[table], after x_1 ... x_(n-1). One value a component.
  [[nodiscard]] auto convolved(Eigen::Index table) const { return sums_.row(table * block + position_); }

  // The weight of x_0 at the same step n.
  [[nodiscard]] double start(Eigen::Index table) const { return start_(position_, table); }

  [[nodiscard]] std::size_t bytes() const;

 private:
  void fill_table(const WeightTable& weights, Eigen::Index table, const ExponentialSum& sum);
  void pass_on();
  void advance_block();
  void advance_start();

  Eigen::Index position_ = 0;  // of the next sample in its block
  bool running_sums_;
  Vec decay_minus_one_;              // exp(-nodes block) - 1
  Matrix gather_;                    // nodes x block: what each sample of a block adds to the states
  Matrix samples_;                   // (recent + block) x components
  Matrix states_, carries_, input_;  // nodes x components

  // The tables stand below each other.
  Matrix inner_;  // recent x recent of each: w(row - column), 0 where row <= column
  Matrix near_;   // block x recent of each: w(recent + row - column)
  Matrix far_;    // block x nodes of each: c_m exp(-nodes[m] (recent + 1 + row))
  Matrix sums_;   // block x components of each

  // The weights of x_0, one column a table: those of this block, their exact part, and their own states, in
  // which x_0 = 1 is a sample as any other.
  Matrix start_, start_near_;
  std::vector<Matrix> start_far_;  // block x nodes; empty where the weights are 0
  Vec start_states_, start_carries_, start_input_, start_later_;
};

}  // namespace fde
