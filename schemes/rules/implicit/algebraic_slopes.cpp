// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/algebraic_slopes.hpp"

#include <Eigen/LU>

namespace fde {

Matrix algebraic_slopes(const Problem& problem, const Matrix& jacobian) {
  const auto algebraic = algebraic_rows(problem);
  if (algebraic.empty()) return {};
  Matrix slopes = Matrix::Zero(jacobian.rows(), jacobian.cols()), others = jacobian(algebraic, Eigen::all);
  others(Eigen::all, algebraic).setZero();
  const Eigen::FullPivLU<Matrix> factors(jacobian(algebraic, algebraic));
  if (jacobian.allFinite() && factors.isInvertible()) slopes(algebraic, Eigen::all) = -factors.solve(others);
  return slopes;
}

}  // namespace fde
