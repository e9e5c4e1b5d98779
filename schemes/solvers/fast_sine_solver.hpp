// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

#include "fdebench/schemes/solvers/five_point_matrix.hpp"
#include "fdebench/schemes/solvers/sine_transform.hpp"

namespace fde {

// Solves with matrices of constant stencils on n x m points: a sine transform along the shorter lines, then
// for each mode k elimination with a tridiagonal Toeplitz matrix across them, of diagonal d + 2 a cos(pi k /
// (n + 1)). The pivots are computed in each solve, so that no state depends on a stencil.
class FastSineSolver {
 public:
  FastSineSolver(Eigen::Index n, Eigen::Index m);

  // Whether the elimination is stable: each tridiagonal matrix is (weakly) diagonally dominant or, if it is
  // complex, has no pivot that is too small.
  [[nodiscard]] bool is_stable_for(const Stencil<double>& stencil) const;
  [[nodiscard]] bool is_stable_for(const Stencil<std::complex<double>>& stencil) const;

  // The sign of the determinant. Precondition: is_stable_for(stencil).
  [[nodiscard]] int determinant_sign(const Stencil<double>& stencil) const;

  // Replaces b, of n m entries, by the solution. Precondition: is_stable_for(stencil).
  void solve(const Stencil<double>& stencil, Vec& b) const;
  void solve(const Stencil<std::complex<double>>& stencil, ComplexVec& b) const;

 private:
  template <class Scalar>
  struct Lines;
  template <class Scalar>
  [[nodiscard]] static bool is_dominant(const Lines<Scalar>& lines);
  template <class Scalar>
  [[nodiscard]] Lines<Scalar> lines(const Stencil<Scalar>& stencil) const;
  void forward(Vec& field, Matrix& modes) const;
  void backward(const Matrix& modes, Vec& field) const;

  Eigen::Index n_, m_;
  SineTransform transform_;  // of length min(n, m)
  mutable Matrix modes_, other_modes_;
  mutable Vec transposed_, real_, imaginary_;
};

}  // namespace fde
