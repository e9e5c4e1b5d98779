#pragma once

#include "adaptive/stage_matrix.hpp"
#include "implicit/complex_factors.hpp"
#include "implicit/sparse_factors.hpp"

namespace fde {

// The matrix of a step where all rows have one order and so the same weights K, and df/dy = A is sparse:
//   Y - A Y K^T = B for Y of a column a stage.
// With the eigenvalues and eigenvectors of K^T, K^T Q = Q L, it falls into (1 - l_i A) z_i = (B Q)_i, Y = Z
// Q^(-1): a real matrix and one of a complex pair (Hairer & Wanner, section IV.8). For all orders up to 1 the
// three eigenvalues are that, their real parts are positive, and the condition number of Q is between 4.3
// and 8.8.
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
  std::unique_ptr<SparseFactors> of_real_;
  std::unique_ptr<ComplexFactors> of_complex_;
};

}  // namespace fde
