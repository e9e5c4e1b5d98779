#pragma once

#include <Eigen/LU>

#include "implicit/newton_matrix.hpp"

namespace fde {

// Takes what the problem tells of df/dy, or differences of rhs.
class DenseNewtonMatrix : public NewtonMatrix {
 public:
  explicit DenseNewtonMatrix(const Problem& problem);

  void linearise(Run& run, const StepEquations& step, In y, In f) override;
  bool factorise_linear(const Vec& kappa) override;
  int determinant_sign() override;
  void add_to_diagonal(const Vec& values) override { matrix_.diagonal() += values; }
  void factorise() override { factors_.compute(matrix_); }
  void solve(Vec& b) const override;
  void factorise_and_solve(Vec& b) override;
  [[nodiscard]] const RowScales& rows() const override { return rows_; }

 private:
  void assemble(const Vec& kappa);  // from df/dy in the matrix's place
  [[nodiscard]] bool singular() const;

  const Problem& problem_;
  RowScales rows_;
  Matrix matrix_;
  Eigen::PartialPivLU<Matrix> factors_;
};

}  // namespace fde
