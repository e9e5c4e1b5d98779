// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

using ComplexVec = Eigen::VectorXcd;

// Constant coefficients of a point of a rectangle (diagonal), of its neighbours on the same line
// (line_coupling) and of those on the adjacent lines (cross_coupling). With 0 beyond the border the matrix is
// a sum of Kronecker products of tridiagonal Toeplitz matrices,
//   diagonal 1 x 1 + line_coupling 1 x E + cross_coupling E x 1,   E of ones beside the diagonal.
template <class Scalar>
struct Stencil {
  Scalar diagonal, line_coupling, cross_coupling;
};

// A symmetric matrix that couples each of n x m points with itself and its neighbours; row i + n j belongs to
// point (i, j).
struct FivePointMatrix {
  Eigen::Index n, m;
  Vec diagonal;
  Vec line_coupling, cross_coupling;  // coupling with the next point on the line, and with that on the next
                                      // line; 0 where there is none

  [[nodiscard]] Stencil<double> mean_stencil() const;
  // The stencil, if it is the same at all points up to rounding.
  [[nodiscard]] std::optional<Stencil<double>> constant_stencil() const;
  // Whether each diagonal entry is larger than the sum of the others of its row, in modulus: the matrix is
  // positive definite then.
  [[nodiscard]] bool is_diagonally_dominant() const;
  // Sets y to the matrix times x.
  void multiply(const Vec& x, Vec& y) const;
};

// A five-point matrix recognised from its entries. nullopt: there are other entries, the matrix is not
// symmetric, or n or m is 1.
std::optional<FivePointMatrix> as_five_point(const SparseMatrix& matrix);

// The same as a sparse matrix.
SparseMatrix to_sparse(const FivePointMatrix& matrix);

}  // namespace fde
