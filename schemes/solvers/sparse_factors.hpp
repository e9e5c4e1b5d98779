// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// A factorised sparse matrix.
class SparseFactors {
 public:
  SparseFactors() = default;
  SparseFactors(const SparseFactors&) = delete;
  SparseFactors& operator=(const SparseFactors&) = delete;
  virtual ~SparseFactors() = default;

  // Factorises a matrix. Precondition: it has the pattern of the matrix passed to the constructor. Returns
  // false where the method is not applicable: a value is not finite, the matrix is singular, or digits would
  // be lost.
  virtual bool factorise(const SparseMatrix& matrix) = 0;

  // The sign of the determinant.
  [[nodiscard]] virtual int determinant_sign() = 0;

  // Replaces b by the solution.
  virtual void solve(Vec& b) const = 0;

  // The method that solves; and the method chosen at first, which ConjugateGradients may have replaced.
  [[nodiscard]] virtual std::string_view active_method() const = 0;
  [[nodiscard]] virtual std::string_view chosen_method() const { return active_method(); }

  // Saves or restores what one solve leaves for the next with the same matrix.
  virtual void state(Archive& /*archive*/) {}
};

// The factors of a matrix by the first applicable method of this list, fastest first; nullptr: none is.
//   tridiagonal          elimination without pivoting, of diagonally dominant matrices
//   fast_sine            constant coefficients in a rectangle
//   conjugate_gradients  other symmetric matrices of a large rectangle
//   cholesky             L D L^T with minimum degree ordering, of symmetric positive definite matrices
//   lu                   L U with pivoting (Eigen::SparseLU)
// If `method` is given, only that method is tried.
std::unique_ptr<SparseFactors> sparse_factors(const SparseMatrix& matrix, std::string_view method = {});

}  // namespace fde
