// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/cholesky_factors.hpp"

#include <algorithm>

namespace fde {
namespace {

template <class Factors, class Vector>
void solve_in_place(const Factors& factors, Vector& b) {
  Vector ordered = factors.permutationP() * b;
  factors.matrixL().solveInPlace(ordered);
  ordered.array() /= factors.vectorD().array().template cast<typename Vector::Scalar>();
  factors.matrixU().solveInPlace(ordered);
  b = factors.permutationPinv() * ordered;
}

}  // namespace

bool CholeskyFactors::is_applicable(const SparseMatrix& matrix) {
  const SparseMatrix other = matrix.transpose();
  const auto* const values = matrix.valuePtr();
  return std::equal(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1,
                    other.outerIndexPtr()) &&
         std::equal(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros(),
                    other.innerIndexPtr()) &&
         std::equal(values, values + matrix.nonZeros(), other.valuePtr());
}

bool CholeskyFactors::factorise(const SparseMatrix& matrix) {
  if (!is_applicable(matrix)) return false;
  factors_.factorize(matrix);
  return factors_.info() == Eigen::Success && (factors_.vectorD().array() > 0.0).all() &&
         factors_.vectorD().allFinite();
}

void CholeskyFactors::solve(Vec& b) const { solve_in_place(factors_, b); }

void CholeskyFactors::solve(Eigen::VectorXcd& b) const { solve_in_place(factors_, b); }

}  // namespace fde
