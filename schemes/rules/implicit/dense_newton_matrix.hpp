// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/implicit/newton_matrix.hpp"
#include "fdebench/schemes/solvers/dense_factors.hpp"

namespace fde {

// Uses the problem's df/dy, or differences of rhs where it has none.
class DenseNewtonMatrix final : public NewtonMatrix {
 public:
  // The problem must outlive the matrix.
  explicit DenseNewtonMatrix(const Problem& problem);

  void linearise(Run& run, const StepEquations& step, In y, In f) override;
  bool factorise_linear(const Vec& kappa) override;
  int determinant_sign() override { return factors_.determinant_sign(); }
  void add_to_diagonal(const Vec& values) override { matrix_.diagonal() += values; }
  void factorise() override { factors_.factorise(matrix_); }
  void solve(Vec& b) const override { factors_.solve(b); }
  void state(Archive& archive) override;
  [[nodiscard]] const RowScales& rows() const override { return rows_; }

 private:
  void assemble(const Vec& kappa);  // from df/dy, which is stored in matrix_

  const Problem& problem_;
  RowScales rows_;
  Matrix matrix_;
  DenseFactors factors_;
};

}  // namespace fde
