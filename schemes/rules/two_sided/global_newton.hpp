// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "fdebench/schemes/rules/two_sided/global_equations.hpp"
#include "fdebench/schemes/rules/two_sided/two_grid_solver.hpp"

namespace fde {

// Solves Newton's linear equations by elimination of the left rows. Given the right rows, the left ones
// follow by stepping forward from 0; given these, the right ones by stepping backward from the end. With this
// forward-backward sweep S the equations become equations for the right rows and p alone, without the
// stiffness of either side: z - S(z) = S(r). They are solved by GMRES, each application O(N). Without right
// rows and unknown initial values one sweep is the solution.
//
// Where solutions of one side alone grow by many powers of ten until the end, the result is useless. Only its
// residual shows this.
class CondensedSystem {
 public:
  // The linearisation must outlive this object.
  explicit CondensedSystem(const Linearisation& linearisation);

  // The increment of Newton's method for this residual.
  [[nodiscard]] GridFunction solution(const Residual& residual) const;
  // Memory of the vectors of GMRES.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The unknowns z of GMRES: the right rows, if there are left rows too, and the unknown initial values.
  [[nodiscard]] Vec unknowns(const Rows& y, In conditions) const;
  [[nodiscard]] Rows right_part(const Vec& z) const;
  [[nodiscard]] Vec applied(const Vec& z) const;

  const Linearisation& linearisation_;
  const GlobalEquations& equations_;
  Eigen::Index right_value_count_;  // number of values of right rows in z
  double scale_;                    // gives an unknown initial value the weight of a row at all times
};

// Newton's increments at all times at once: by CondensedSystem as long as its increments solve the equations,
// from then on by TwoGridSolver.
class NewtonIncrements {
 public:
  enum class First { condensed, two_grid };
  // The equations must outlive this object. first: the method to begin with.
  explicit NewtonIncrements(const GlobalEquations& equations, First first = First::condensed);

  // The increment at a guess with this residual; its values are not finite where there is none.
  GridFunction at(Run& run, const GridFunction& guess, const Residual& residual);

  // Memory of Jacobians, of the vectors of GMRES and of the factors of the coarse grid.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The relative residual of the linear equations, |r - left-hand side| / |r|.
  [[nodiscard]] double relative_residual(const GridFunction& increment, const Residual& residual) const;

  const GlobalEquations& equations_;
  Linearisation linearisation_;
  CondensedSystem condensed_;
  int coarse_steps_;
  std::unique_ptr<TwoGridSolver> two_grid_;  // nullptr: CondensedSystem is used
};

// The result of Newton's method.
struct NewtonResult {
  GridFunction guess;
  double residual;  // its norm
  bool converged;
};

// Newton's method with step halving at all times at once, from a start. It has converged where the last
// increment is below tolerance * |y|, or has stopped shrinking below 1e-10 * |y|.
NewtonResult solve_by_newton(const GlobalEquations& equations, NewtonIncrements& increments, Run& run,
                             double tolerance, GridFunction start);

}  // namespace fde
