// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// Evaluates the sums of the starting weights, sum_{j<s} W_i(n, j) f_j for every row i, for increasing n. They
// are computed a block of steps at a time, O(1) work a step.
class StartingCorrection {
 public:
  // For n up to `steps`. Rows with equal tables share their weights.
  StartingCorrection(const std::vector<WeightTable>& tables, const std::vector<double>& powers, int steps);

  // All weights w_i(n-j) + W_i(n, j) of f_0 ... f_(s-1) at a step n < s, one row a row i, one column a j.
  [[nodiscard]] Matrix weights(int n) const;

  // Sets f_0 ... f_(s-1), one column each. Call it before add().
  void start(const Matrix& f);

  // Adds the sums of step n to `sums`, one entry a row. n must not decrease from call to call.
  void add(int n, Out sums);

  [[nodiscard]] std::size_t bytes() const;

  // Archives f_0 ... f_(s-1), also before start(); the sums of the block are recomputed.
  void state(Archive& archive);

 private:
  static constexpr int block = 32;
  using Block = Eigen::Array<double, block, 1>;
  void compute_block(int n);
  void load_piece(std::size_t piece);
  [[nodiscard]] const StartingWeights& of_row(Eigen::Index i) const {
    return *of_orders_[row_[static_cast<std::size_t>(i)]];
  }

  std::vector<WeightTable> tables_;                                // each once
  std::vector<std::shared_ptr<const StartingWeights>> of_orders_;  // for each of tables_
  std::vector<std::size_t> row_;                                   // for each row its index in both
  int near_ = 0;                                                   // K: the steps with tabulated weights
  Matrix f_;                                                       // s x rows
  Matrix smooth_, alternating_;  // Chebyshev coefficients of the sums on this piece, one column a row
  double begin_ = 0.0;           // first step of this piece
  int first_ = 0;                // step of the block in sums_; 0: none yet
  Matrix sums_;                  // block x rows
};

}  // namespace fde
