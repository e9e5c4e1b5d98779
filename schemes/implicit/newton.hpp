#pragma once

#include <memory>
#include <optional>

#include "implicit/extrapolation.hpp"
#include "implicit/newton_matrix.hpp"
#include "implicit/outrun_growth.hpp"
#include "implicit/wear.hpp"
#include "stepping/run.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// Solves y_i = past_i + kappa_i f_i(t, y), and 0 = f_i(t, y) in algebraic rows, for y, step after step of one
// run.
//
// A problem with a linear part A is solved with one factorisation of I - kappa A as long as kappa stays the
// same. Otherwise Newton's method takes the Jacobian of the problem, or differences of rhs where it has none,
// until the last increment is below tolerance * |y|, or has stopped to shrink below 1e-10 * |y|: there it is
// rounding.
//
// Of more than four rows the factorised matrix is kept from step to step as long as increments shrink fast
// with it, and the first guess continues the last three steps. Where they do not, or of fewer rows, where
// factors cost no more than an iteration, the matrix is made anew in each iteration from the guess on. Where
// three increments are no smaller than those before them, as when the solution near the guess has just
// vanished, it starts again from where pseudo time steps lead to; where these lead to nothing, it goes on
// from where it had come to. Where derivatives at the guess are not finite, as that of y^(1/6) at 0, it
// starts from y = past + kappa f(t, guess), up to eight times.
//
// |y| is the largest of the other unknowns where there are algebraic rows. An unknown lambda_i of an
// algebraic row counts as what it does to the equations, max_k |M_ki| |lambda_i| with M the matrix of
// Newton's method, and relative to |y| or, where it is larger, to itself. That is about |lambda_i| where its
// own row determines it. A multiplier, which only enters other rows with kappa, counts with kappa: it is
// known no better than rounding / kappa, and is not asked for more. What the last increment leaves of a
// constraint is of second order in that increment, or rounding.
class NewtonSolver {
 public:
  NewtonSolver(const Problem& problem, double tolerance);

  // Improves the guess y to the solution. Not `finished` when 350 iterations do not suffice, a value is not
  // finite, the constraints of a linear problem depend on each other, or it has a mode that grows so fast
  // that the step outruns it.
  Ending solve(Run& run, const StepEquations& step, Out y);

 private:
  bool solve_nonlinear(Run& run, const StepEquations& step, Out y);
  bool solve_linear(Run& run, const StepEquations& step, Out y);
  // From the continued path with the kept factors; y is the result, or, where these do not serve, as it was.
  bool iterate_kept(Run& run, const StepEquations& step, Out y);
  // From y on: anew in each iteration, and, where that leads nowhere, from where pseudo time steps lead to,
  // or where y has no derivatives.
  bool iterate_anew(Run& run, const StepEquations& step, Out y);
  // From y = past + kappa f(t, y), again and again, where the derivatives at y are not finite. y is NaN where
  // that does not help.
  bool iterate_past_infinite_derivatives(Run& run, const StepEquations& step, Out y);
  // Newton's method from y on, given up at the last of so many increments that are no smaller than the one
  // before.
  bool iterate(Run& run, const StepEquations& step, Out y, int most_setbacks);
  // Brings y so close to a solution that Newton's method should converge. Follows mass y' = past + kappa f(t,
  // y) - y in a pseudo time by linearly implicit Euler steps (Kelley & Keyes, SIAM J. Numer. Anal. 35 (1998))
  // that grow where the equations are nearly linear along them: a step without end is one of Newton's method.
  bool approach(Run& run, const StepEquations& step, Out y);
  // How far the equations are from linear along an increment of a pseudo time step: the next one, relative to
  // it.
  double bend(Run& run, const StepEquations& step, In y, const Vec& increment, double inverse_step);
  // The matrix becomes that at y, and rest what y leaves of the equations.
  void linearise(Run& run, const StepEquations& step, In y, Vec& rest);

  const Problem& problem_;
  double tolerance_;
  std::unique_ptr<NewtonMatrix> matrix_;
  Wear wear_;
  Extrapolation path_;
  Vec f_, increment_, near_;
  // Of a linear problem: the kappa for which the matrix is factorised, and whether it has a solution then.
  std::optional<Vec> factorised_for_;
  bool solvable_ = false;
  std::optional<OutrunGrowth> growth_;
  bool outruns_ = false;
};

}  // namespace fde
