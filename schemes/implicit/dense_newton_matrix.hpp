#pragma once

#include <Eigen/LU>
#include <memory>

#include "implicit/newton_matrix.hpp"

namespace fde {

// Takes what the problem tells of df/dy, or differences of rhs. Most problems have a few components, where a
// size that the compiler knows saves most of the time: it is 1 to 8, or Eigen::Dynamic.
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
  void assemble(const Vec& kappa);  // from df/dy in the matrix's place

  using Square = Eigen::Matrix<double, size, size>;

  const Problem& problem_;
  RowScales rows_;
  Square matrix_;
  Eigen::PartialPivLU<Square> factors_;
};

// Of the size of the problem.
std::unique_ptr<NewtonMatrix> make_dense_newton_matrix(const Problem& problem);

}  // namespace fde
