#pragma once

#include <memory>
#include <string_view>

#include "checkpoint/archive.hpp"
#include "problem/vectors.hpp"

namespace fde {

// A sparse matrix as a product that is quickly solved with.
class SparseFactors {
 public:
  SparseFactors() = default;
  SparseFactors(const SparseFactors&) = delete;
  SparseFactors& operator=(const SparseFactors&) = delete;
  virtual ~SparseFactors() = default;

  // Of a matrix whose entries are where they were in that for which this was made. False where the method
  // does not serve: a value is not finite, the matrix is singular, or digits would be lost.
  virtual bool factorise(const SparseMatrix& matrix) = 0;

  // The sign of the determinant.
  [[nodiscard]] virtual int determinant_sign() = 0;

  // b becomes the solution.
  virtual void solve(Vec& b) const = 0;

  // What solves; and the method asked for, where another may have taken over.
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view method() const { return name(); }

  // What one solve leaves for the next, of factors of the same matrix.
  virtual void state(Archive& /*archive*/) {}
};

// The factors of a matrix by the quickest method that serves, in this order; nullptr: none does.
//   tridiagonal          elimination without exchange of rows, of rows whose diagonal outweighs the rest
//   fast_sine            of constant coefficients in a rectangle
//   conjugate_gradients  of other symmetric matrices of a large rectangle
//   cholesky             L D L^T in an order of least degree, of symmetric and positive definite matrices
//   lu                   L U with exchange of rows (Eigen::SparseLU)
// With a method by that alone.
std::unique_ptr<SparseFactors> sparse_factors(const SparseMatrix& matrix, std::string_view method = {});

}  // namespace fde
