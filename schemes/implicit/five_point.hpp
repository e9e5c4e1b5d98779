#pragma once

#include <optional>

#include "problem/vectors.hpp"

namespace fde {

using ComplexVec = Eigen::VectorXcd;

// What a point of a rectangle takes of itself and of its neighbours, all points alike: with 0 beyond the
// border a sum of Kronecker products of tridiagonal Toeplitz matrices,
//   diagonal 1 x 1 + along 1 x E + across E x 1,   E of ones beside the diagonal.
template <class Scalar>
struct Stencil {
  Scalar diagonal, along, across;
};

// A symmetric matrix that couples each of n x m points with itself and its neighbours; row i + n j is that of
// point (i, j).
struct FivePoint {
  Eigen::Index n, m;
  Vec diagonal;
  Vec along, across;  // with the point that follows on the line, and with that on the next line; 0 where
                      // there is none

  [[nodiscard]] Stencil<double> mean() const;
  // Where all points are alike, to rounding.
  [[nodiscard]] std::optional<Stencil<double>> constant() const;
  // Whether each diagonal is larger than what stands beside it: the matrix is positive definite then.
  [[nodiscard]] bool dominated() const;
  // y becomes the matrix times x.
  void multiply(const Vec& x, Vec& y) const;
};

// Recognised from the entries alone. None: some are elsewhere, it is not symmetric, or n or m is 1.
std::optional<FivePoint> five_point(const SparseMatrix& matrix);

// The same as a sparse matrix.
SparseMatrix sparse(const FivePoint& matrix);

}  // namespace fde
