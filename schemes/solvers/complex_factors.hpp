// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <memory>
#include <string_view>

#include "fdebench/schemes/solvers/five_point_matrix.hpp"

namespace fde {

// 1 - factor A for a real A, factorised by the fastest applicable method, in the same order as
// sparse_factors: tridiagonal, fast_sine, conjugate_gradients, cholesky, lu. Cholesky's factors are those of
// the real matrix 1 - |factor| A, as a preconditioner of conjugate gradients.
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

// Factors of 1 - factor * matrix, to be used for so many solves; nullptr: no method is applicable. Iterations
// with real factors take less time than complex factors for a few solves, and more for many.
enum class Solves { few, many };
std::unique_ptr<ComplexFactors> complex_factors(const SparseMatrix& matrix, std::complex<double> factor,
                                                Solves solves = Solves::many);

}  // namespace fde
