// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/schemes/solvers/complex_factors.hpp"
#include "fdebench/schemes/solvers/sparse_factors.hpp"

namespace fde {

// The equations X - A X K^T = B of s steps or stages that are coupled by a small s x s matrix K; A is sparse,
// X and B have one column a step. With the real Schur form K^T = Q T Q^T they are Z - A Z T = B Q for Z = X
// Q. T is triangular up to 2 x 2 blocks of conjugate pairs of eigenvalues l, so these are solved from left to
// right: for each real eigenvalue a system with 1 - l A, for each pair a complex one. Method of Bartels &
// Stewart, Commun. ACM 15 (1972), in the form of Golub, Nash & Van Loan, IEEE Trans. Automat. Control 24
// (1979).
class SylvesterFactors {
 public:
  // For scale K in place of K; the Schur form is computed anew where K is not that of the call before.
  // Returns false where a system is singular. The matrix A must outlive the factors.
  bool factorise(const SparseMatrix& a, const Matrix& k, double scale = 1.0, double accuracy = 0x1p-53);

  // The sign of the determinant of 1 - K x A (Kronecker product).
  [[nodiscard]] int determinant_sign() const;

  // Replaces B, stacked by columns, by the solution X.
  void solve(Vec& b) const;

  // The method of the systems, the complex ones where there are any.
  [[nodiscard]] std::string_view method() const;

 private:
  // A pair of columns with a complex eigenvalue: w = Z q solves w - l A w = (right-hand side) q with an
  // eigenvector q of the block, and Z is twice the real part of w p.
  struct Pair {
    std::unique_ptr<ComplexFactors> factors;
    Eigen::Vector2cd q;
    Eigen::RowVector2cd p;
  };
  using Block = std::variant<std::unique_ptr<SparseFactors>, Pair>;
  bool add_real(double eigenvalue);
  bool add_pair(const Eigen::Matrix2d& block, double accuracy);

  const SparseMatrix* a_ = nullptr;
  Matrix k_, q_, schur_, t_;   // t_ = scale schur_
  std::vector<Block> blocks_;  // of the diagonal of T
};

}  // namespace fde
