// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>

#include "fdebench/schemes/solvers/sparse_factors.hpp"

namespace fde {

// L D L^T of symmetric positive definite matrices, with a minimum degree ordering (Eigen::SimplicialLDLT).
class CholeskyFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "cholesky";

  explicit CholeskyFactors(const SparseMatrix& matrix) { factors_.analyzePattern(matrix); }

  // Whether the matrix is symmetric.
  static bool is_applicable(const SparseMatrix& matrix);
  bool factorise(const SparseMatrix& matrix) override;
  [[nodiscard]] int determinant_sign() override { return 1; }
  void solve(Vec& b) const override;
  void solve(Eigen::VectorXcd& b) const;
  [[nodiscard]] std::string_view active_method() const override { return id; }

 private:
  Eigen::SimplicialLDLT<SparseMatrix> factors_;
};

}  // namespace fde
