// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>
#include <memory>

#include "fdebench/schemes/rules/implicit/newton_matrix.hpp"

namespace fde {

// Uses the problem's df/dy, or differences of rhs where it has none. size: the number of components, 1 to 8,
// or Eigen::Dynamic. Most problems have a few components, for which a size known at compile time saves most
// of the time.
template <int size>
class DenseNewtonMatrix : public NewtonMatrix {
 public:
  explicit DenseNewtonMatrix(const Problem& problem);

  void linearise(Run& run, const StepEquations& step, In y, In f) override;
  bool factorise_linear(const Vec& kappa) override;
  int determinant_sign() override;
  void add_to_diagonal(const Vec& values) override { matrix_.diagonal() += values; }
  void factorise() override { factors_.compute(matrix_); }
  void solve(Vec& b) const override;
  void state(Archive& archive) override;
  [[nodiscard]] const RowScales& rows() const override { return rows_; }

 private:
  void assemble(const Vec& kappa);  // from df/dy, which is stored in matrix_

  using Square = Eigen::Matrix<double, size, size>;

  const Problem& problem_;
  RowScales rows_;
  Square matrix_;
  Eigen::PartialPivLU<Square> factors_;
};

// A matrix for the size of the problem. The problem must outlive it.
std::unique_ptr<NewtonMatrix> make_dense_newton_matrix(const Problem& problem);

}  // namespace fde
