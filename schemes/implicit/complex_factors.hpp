#pragma once

#include <complex>
#include <memory>
#include <string_view>

#include "implicit/five_point.hpp"

namespace fde {

// 1 - factor A for a real A, factorised by the quickest method that serves, as sparse_factors does with real
// matrices: tridiagonal, fast_sine, lu. Conjugate gradients and Cholesky's factors have no complex
// counterpart here.
class ComplexFactors {
 public:
  ComplexFactors() = default;
  ComplexFactors(const ComplexFactors&) = delete;
  ComplexFactors& operator=(const ComplexFactors&) = delete;
  virtual ~ComplexFactors() = default;

  // Of a matrix whose entries are where they were in that for which this was made. False where the method
  // does not serve.
  virtual bool factorise(const SparseMatrix& matrix, std::complex<double> factor) = 0;

  // b becomes the solution.
  virtual void solve(ComplexVec& b) const = 0;

  [[nodiscard]] virtual std::string_view name() const = 0;
};

// nullptr: no method serves.
std::unique_ptr<ComplexFactors> complex_factors(const SparseMatrix& matrix, std::complex<double> factor);

}  // namespace fde
