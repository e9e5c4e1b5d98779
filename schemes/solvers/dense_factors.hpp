// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>
#include <array>

#include "fdebench/schemes/problem/vectors.hpp"

// Compiled once, in dense_factors.cpp.
extern template class Eigen::PartialPivLU<Eigen::MatrixXd>;

namespace fde {

// The factors P A = L U of a dense matrix, with partial pivoting. Most problems have a few components, for
// which loops over a size that is known at compile time save most of the time; larger ones have those of
// Eigen.
class DenseFactors {
 public:
  explicit DenseFactors(Eigen::Index size);

  // Precondition: the matrix has the size of the constructor.
  void factorise(const Matrix& matrix);

  // Replaces b by the solution x of A x = b. Precondition: factorise() has been called.
  void solve(Vec& b) const;

  // 1 or -1; 0 where the matrix is singular or not finite.
  [[nodiscard]] int determinant_sign() const;

 private:
  static constexpr std::size_t largest_small = 8;
  using Exchanges =
      std::array<std::size_t, largest_small>;  // the row that elimination step k exchanged with row k
  struct Loops {                               // for one size
    void (*factorise)(double* matrix, Exchanges& exchanges);
    void (*solve)(const double* factors, const Exchanges& exchanges, double* b);
  };

  Eigen::Index size_;
  Loops loops_{};  // empty for sizes above largest_small
  std::array<double, largest_small * largest_small> small_{};
  Exchanges exchanges_{};
  Eigen::PartialPivLU<Matrix> large_;
};

}  // namespace fde
