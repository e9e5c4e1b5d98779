// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <memory>
#include <string_view>

#include "fdebench/schemes/solvers/five_point_matrix.hpp"

namespace fde {

// 1 - factor A for a real A, factorised by the first applicable method of this list, fastest first:
//   tridiagonal          elimination without pivoting, of diagonally dominant matrices
//   fast_sine            constant coefficients in a rectangle
//   cholesky             conjugate gradients preconditioned by L D L^T of 1 - |factor| A
//   conjugate_gradients  other symmetric matrices of a large rectangle, preconditioned by sines
//   lu                   L U with pivoting
class ComplexFactors {
 public:
  ComplexFactors() = default;
  ComplexFactors(const ComplexFactors&) = delete;
  ComplexFactors& operator=(const ComplexFactors&) = delete;
  virtual ~ComplexFactors() = default;

  // Factorises 1 - factor * matrix. Precondition: the matrix has the pattern of the first one. Returns false
  // where the method is not applicable.
  virtual bool factorise(const SparseMatrix& matrix, std::complex<double> factor) = 0;

  // Replaces b by the solution.
  virtual void solve(ComplexVec& b) const = 0;

  [[nodiscard]] virtual std::string_view name() const = 0;
};

// Factors of 1 - factor * matrix; nullptr: no method is applicable. Iterations end where the error of the
// solution is below `accuracy`, relative to its largest entry: by default below rounding.
std::unique_ptr<ComplexFactors> complex_factors(const SparseMatrix& matrix, std::complex<double> factor,
                                                double accuracy = 0x1p-53);

}  // namespace fde
