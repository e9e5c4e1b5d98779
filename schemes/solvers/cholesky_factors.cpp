// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/cholesky_factors.hpp"

#include <algorithm>

namespace fde {

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

void CholeskyFactors::solve(Vec& b) const {
  ordered_ = factors_.permutationP() * b;
  factors_.matrixL().solveInPlace(ordered_);
  ordered_.array() /= factors_.vectorD().array();
  factors_.matrixU().solveInPlace(ordered_);
  b = factors_.permutationPinv() * ordered_;
}

}  // namespace fde
