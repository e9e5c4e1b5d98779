// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/two_sided/global_equations.hpp"
#include "fdebench/schemes/solvers/dense_factors.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// Newton's linear equations on a coarse grid as one dense matrix. The matrices of the rules are computed
// once; each factorisation uses the Jacobians of a linearisation on that grid.
class DenseLinearisation {
 public:
  explicit DenseLinearisation(const GlobalEquations& equations);

  void factorise(const Linearisation& linearisation);
  // x and p for these right-hand sides.
  [[nodiscard]] GridFunction solution(const Linearisation::LeftHandSides& right) const;

 private:
  [[nodiscard]] Eigen::Index size() const { return rows_ * times_; }

  Eigen::Index rows_, times_;
  std::vector<Matrix> weights_;  // of f at all times in each row
  Matrix mass_;                  // one row a component, one column a time: 1, in algebraic rows 0
  Matrix unknown_columns_;       // -B
  Eigen::PartialPivLU<Matrix> factors_{};
};

// Newton's linear equations of all times at once by GMRES with a preconditioner of two grids (K. E. Atkinson,
// The Numerical Solution of Integral Equations of the Second Kind, 1997, section 6.3): first the local
// solution, then a correction for its residual, solved on a grid of 64 to 256 steps by elimination and
// interpolated linearly. Unlike CondensedSystem it is not impaired by solutions that grow.
class TwoGridSolver {
 public:
  // The equations must outlive this object.
  TwoGridSolver(const GlobalEquations& equations, int coarse_steps);

  // Linearises the equations of the coarse grid at this guess.
  void update(Run& run, const GridFunction& guess);
  // The increment of Newton's method with the linearisation `fine`, for this residual.
  [[nodiscard]] GridFunction solution(const Linearisation& fine, const Residual& residual) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] GridFunction preconditioned(const Linearisation& fine,
                                            const Linearisation::LeftHandSides& right) const;
  [[nodiscard]] const Vec& times() const { return equations_.discretisation().left; }
  [[nodiscard]] const Vec& coarse_times() const { return coarse_equations_.discretisation().left; }

  const GlobalEquations& equations_;
  GlobalEquations coarse_equations_;
  Linearisation coarse_;
  DenseLinearisation dense_;
};

// Interpolates y linearly from increasing times to others, one column a time. Precondition: the first and the
// last time are the same.
Rows interpolate_linearly(const Vec& from, const Rows& y, const Vec& to);

}  // namespace fde
