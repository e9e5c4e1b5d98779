#pragma once

#include <Eigen/SparseLU>

#include "implicit/newton_matrix.hpp"

namespace fde {

// The order of elimination depends on where the entries are and not on what they are: it is found once.
class SparseNewtonMatrix : public NewtonMatrix {
 public:
  explicit SparseNewtonMatrix(const Problem& problem);

  void linearise(Run& run, const StepEquations& step, In y, In f) override;
  bool factorise_linear(const Vec& kappa) override;
  int determinant_sign() override;
  void add_to_diagonal(const Vec& values) override { matrix_.diagonal() += values; }
  void factorise() override;
  void solve(Vec& b) const override;
  [[nodiscard]] const RowScales& rows() const override { return rows_; }

 private:
  void assemble(const SparseMatrix& derivatives, const Vec& kappa);

  const Problem& problem_;
  RowScales rows_;
  SparseMatrix identity_, derivatives_, matrix_, analysed_;
  Eigen::SparseLU<SparseMatrix> factors_;
};

}  // namespace fde
