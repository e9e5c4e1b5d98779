#pragma once

#include <optional>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

using ComplexVec = Eigen::VectorXcd;

// Constant coefficients of a point of a rectangle and of its neighbours. With 0 beyond the border the matrix
// is a sum of Kronecker products of tridiagonal Toeplitz matrices,
//   diagonal 1 x 1 + along 1 x E + across E x 1,   E of ones beside the diagonal.
template <class Scalar>
struct Stencil {
  Scalar diagonal, along, across;
};

// A symmetric matrix that couples each of n x m points with itself and its neighbours; row i + n j belongs to
// point (i, j).
struct FivePointMatrix {
  Eigen::Index n, m;
  Vec diagonal;
  Vec along, across;  // coupling with the next point on the line, and with that on the next line; 0 where
                      // there is none

  [[nodiscard]] Stencil<double> mean() const;
  // The stencil, if it is the same at all points up to rounding.
  [[nodiscard]] std::optional<Stencil<double>> constant() const;
  // Whether each diagonal entry is larger than the sum of the others of its row, in modulus: the matrix is
  // positive definite then.
  [[nodiscard]] bool dominated() const;
  // Sets y to the matrix times x.
  void multiply(const Vec& x, Vec& y) const;
};

// A five-point matrix recognised from its entries. nullopt: there are other entries, the matrix is not
// symmetric, or n or m is 1.
std::optional<FivePointMatrix> as_five_point(const SparseMatrix& matrix);

// The same as a sparse matrix.
SparseMatrix sparse(const FivePointMatrix& matrix);

}  // namespace fde
