#pragma once

#include "start_weights/start_weights.hpp"
#include "stepping/run.hpp"

namespace fde {

// sum_{j<s} W_i(n, j) f_j of every row i, step after step: a block of steps at a time, for O(1) work a step.
class StartCorrection {
 public:
  // Rows of equal order share their weights. For so many steps.
  StartCorrection(const std::vector<WeightTable>& tables, const std::vector<double>& powers, int steps);

  // All weights of f_0 ... f_(s-1) at a step n < s, w_i(n-j) + W_i(n, j) with w of the rule itself, one row a
  // row.
  [[nodiscard]] Matrix weights(int n) const;

  // f_0 ... f_(s-1), one column each, before the sums are asked for.
  void start(const Matrix& f);

  // Adds those of step n, which is not before the one asked for last.
  void add(int n, Out sums);

  [[nodiscard]] std::size_t bytes() const;

  // Before or after start; what is summed a block at a time is summed again.
  void state(Archive& archive);

 private:
  static constexpr int block = 32;
  using Block = Eigen::Array<double, block, 1>;
  void fill(int n);
  void enter_piece(std::size_t piece);
  [[nodiscard]] const StartWeights& of_row(Eigen::Index i) const {
    return *of_orders_[row_[static_cast<std::size_t>(i)]];
  }

  std::vector<WeightTable> tables_;  // without repetition
  std::vector<std::shared_ptr<const StartWeights>> of_orders_;
  std::vector<std::size_t> row_;  // of each row its entry in both
  int near_ = 0;                  // the steps whose weights are stored
  Matrix f_;
  Matrix smooth_, alternating_;  // coefficients of the sums on this piece, one column a row
  double begin_ = 0.0;           // of this piece
  int first_ = 0;                // step of the block in sums_; 0: none yet
  Matrix sums_;                  // block x rows
};

}  // namespace fde
