// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fdebench/reference/special_functions/prabhakar_and_matrix/big_matrix.hpp"

namespace fde::reference {

// The real Schur form T = U^T A U of a square matrix, at the current precision, with U a permutation where T
// is triangular then; for a complex A + iB, the Schur form of the real matrix [A -B; B A], which has the
// conjugate eigenvalues as well.
class SchurForm {
 public:
  using Point = std::complex<long double>;

  // Throws std::runtime_error when the QR iteration does not converge.
  explicit SchurForm(const BigMatrix& matrix);

  [[nodiscard]] const std::vector<Point>& log_eigenvalues() const { return log_eigenvalues_; }

  // An upper bound of the Euclidean norm of (z' - A)^-1 for |z' - z| <= radius; infinity where there is none.
  // With lower bounds of |z' - t_ii|, triangular solves on moduli bound the row and the column sums of
  // (z' - T)^-1; the norm is at most the root of the product of their maxima, and U does not change it. Valid
  // for defective and stiff matrices as well.
  [[nodiscard]] long double resolvent_norm(const Point& z, long double radius) const;

 private:
  using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  struct Block {  // on the diagonal of T, of one row or two
    int first, rows;
    std::array<Point, 2> eigenvalues, diagonal;
  };
  [[nodiscard]] std::optional<Eigen::Matrix<long double, 2, 2>> block_resolvent(const Block& block,
                                                                                const Point& z,
                                                                                long double radius) const;

  LongMatrix sizes_;  // |T|
  std::vector<Block> blocks_;
  std::vector<Point> log_eigenvalues_;
};

}  // namespace fde::reference
