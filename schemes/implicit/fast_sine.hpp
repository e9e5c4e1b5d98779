#pragma once

#include <complex>

#include "implicit/five_point.hpp"
#include "implicit/sine_transform.hpp"

namespace fde {

// Solves with matrices of constant stencils on n x m points: a sine transform along the shorter lines, and
// across them for each mode k a tridiagonal Toeplitz matrix of diagonal d + 2 a cos(pi k / (n + 1)), by
// elimination. Its pivots are made as they are needed, so that nothing belongs to a stencil.
class FastSine {
 public:
  FastSine(Eigen::Index n, Eigen::Index m);

  // Whether the elimination loses no digits: no diagonal is smaller than what stands beside it.
  template <class Scalar>
  [[nodiscard]] bool serves(const Stencil<Scalar>& stencil) const;

  // The sign of the determinant, where it serves.
  [[nodiscard]] int determinant_sign(const Stencil<double>& stencil) const;

  // b becomes the solution.
  void solve(const Stencil<double>& stencil, Vec& b) const;
  void solve(const Stencil<std::complex<double>>& stencil, ComplexVec& b) const;

 private:
  template <class Scalar>
  struct Lines;
  template <class Scalar>
  [[nodiscard]] Lines<Scalar> lines(const Stencil<Scalar>& stencil) const;
  void forward(Vec& field, Matrix& modes) const;
  void backward(const Matrix& modes, Vec& field) const;

  Eigen::Index n_, m_;
  SineTransform transform_;  // along lines of the lesser of both
  mutable Matrix modes_, other_modes_;
  mutable Vec turned_, real_, imaginary_;
};

}  // namespace fde
