// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// Evaluates the sums of the starting weights, sum_{j<s} W_i(n, j) f_j for every row i, for increasing n. They
// are computed a block of steps at a time: with T the values of the Chebyshev polynomials at these steps, C
// their coefficients in W and F the samples, the sums are T (C F) where rows are few or have several tables,
// and (T C) F where many rows share one table: s multiply-adds a row and step.
class StartingCorrection {
 public:
  // For n up to `steps`. Rows with equal tables share their weights.
  StartingCorrection(const std::vector<WeightTable>& tables, const std::vector<double>& powers, int steps);

  // The number s of samples with starting weights.
  [[nodiscard]] Eigen::Index count() const { return f_.cols(); }

  // The index of the table of each row among the tables that differ, in the order of their first rows.
  [[nodiscard]] const std::vector<std::size_t>& tables_of_rows() const { return row_; }
  // All weights w(n-j) + W(n, j) of f_0 ... f_(s-1) by this table at the steps n = 1 ... s-1, one row a step,
  // one column a j.
  [[nodiscard]] Matrix first_weights(std::size_t table) const;

  // Appends f_0, f_1, ..., one entry a row. Those after f_(s-1) are ignored.
  void push(In f);

  // Adds the sums of step n to `sums`, one entry a row. n must not decrease from call to call.
  // Precondition: f_0 ... f_(s-1) have been pushed.
  void add(int n, Out sums);

  [[nodiscard]] std::size_t bytes() const;

  // Archives f_0 ... f_(s-1); the sums of the block are recomputed.
  void state(Archive& archive);

 private:
  using ChebyshevPiece = StartingWeights::ChebyshevPiece;
  void compute_block(int n);
  void load_piece(double n);
  // The weights of the block from step n on that are stored step by step, one row a step: those of a
  // tabulated step, otherwise the decaying part as far as there is one.
  [[nodiscard]] Eigen::Block<const Matrix> stored_rows(const StartingWeights& weights, int n) const;
  // The sums of coefficients_ (its columns) at the steps of the block from n on; 0 for tabulated steps.
  [[nodiscard]] Matrix values(int n, Eigen::Index columns) const;
  [[nodiscard]] Eigen::Index rows() const { return std::ssize(row_); }
  [[nodiscard]] const StartingWeights& of_row(Eigen::Index i) const {
    return *of_orders_[row_[static_cast<std::size_t>(i)]];
  }

  int steps_;
  std::vector<WeightTable> tables_;                                // each once
  std::vector<std::shared_ptr<const StartingWeights>> of_orders_;  // for each of tables_
  std::vector<std::size_t> row_;                                   // for each row its index in both
  Eigen::Index block_ = lanes;                                     // steps whose sums are computed at once
  int near_ = 0;                                                   // K: the steps with tabulated weights
  Matrix f_;                                                       // rows, padded to whole vectors, x s
  Eigen::Index pushed_ = 0;                                        // number of columns set
  bool one_column_a_row_ = false;                                  // coefficients_: of C F, else of C
  ChebyshevPiece coefficients_;                                    // of this piece
  std::size_t piece_ = 0;                                          // its index, from step n = near_ on
  double begin_ = 0.0;                                             // first step of this piece
  int first_ = 0;                                                  // step of the block in sums_; 0: none yet
  Matrix sums_;                                                    // rows, padded, x block_
};

}  // namespace fde
