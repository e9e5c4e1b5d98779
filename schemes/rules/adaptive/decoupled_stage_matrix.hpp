// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/adaptive/stage_matrix.hpp"
#include "fdebench/schemes/solvers/complex_factors.hpp"
#include "fdebench/schemes/solvers/sparse_factors.hpp"

namespace fde {

// The iteration matrix of a step where all components have one order, hence the same weights K, and df/dy = A
// is sparse:
//   Y - A Y K^T = B,   Y and B with one column a stage.
// With the eigenvalues L and eigenvectors Q of K^T, K^T Q = Q L, it decouples into (1 - l_i A) z_i = (B Q)_i,
// Y = Z Q^(-1): one real system and one complex system of a conjugate pair (Hairer & Wanner, section IV.8).
// For all orders up to 1, K has one real eigenvalue and one complex pair, their real parts are positive, and
// the condition number of Q is between 4.3 and 8.8.
class DecoupledStageMatrix final : public StageMatrix {
 public:
  explicit DecoupledStageMatrix(const Problem& problem) : problem_(problem) {}

  void factorise(Run& run, double t, In y, In f, const StageWeights& weights) override;
  void solve(Vec& b) const override;
  [[nodiscard]] std::string_view solver() const override;

 private:
  using ComplexStages = Eigen::Matrix<std::complex<double>, stages, stages>;

  const Problem& problem_;
  SparseMatrix jacobian_;
  ComplexStages to_modes_, from_modes_;  // Q and its inverse
  Eigen::Index real_ = 0, complex_ = 0;  // the columns of the real eigenvalue, and of one of the pair
  std::unique_ptr<SparseFactors> real_factors_;
  std::unique_ptr<ComplexFactors> complex_factors_;
};

}  // namespace fde
