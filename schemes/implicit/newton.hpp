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
// same. Otherwise Newton's method takes the Jacobian of the problem, or differences of rhs where it has none.
// A step ends with y where the last increment is below tolerance * |y|, or has stopped to shrink below
// 1e-10 * |y|: there it is rounding. Without algebraic rows it ends too where every equation holds to a
// quarter of the tolerance, relative to its own terms past_i and kappa_i f_i. To evaluate f there costs less
// than the iteration that would only have told it. How fast increments shrank before says less: it does not
// see what is small beside the rest of an increment.
//
// The first guess is y = past + kappa f, with f continued from the last five steps. It is trusted where the
// equations confirm it, that is where the first increment is at most a tenth of how far it leads from the
// step before. The factorised matrix is kept from step to step, and made anew at the iterate where an
// increment is more than a twentieth of the one before, or once it is worn. A guess is given up where
// increments do not halve, and where the determinant of a new matrix has another sign than at the last
// solution: where two solutions meet and vanish (as those of y = past + kappa y^2, before y is infinite),
// they differ in it.
//
// From the step before, y as it comes, the iteration then begins again with a new matrix in each iteration.
// Where three increments are no smaller than those before them, as when the solution near the guess has just
// vanished, it starts from where pseudo time steps lead to; where these lead to nothing, it goes on from
// where it had come to. Where derivatives at the guess are not finite, as that of y^(1/6) at 0, it starts
// from y = past + kappa f(t, guess), up to eight times.
//
// The first step of a problem without algebraic rows ends the run where the determinant is negative: from
// y(0) on it is positive for steps short enough, and a longer one has gone past a solution that vanished, or
// past a mode that grows.
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
  // finite, the constraints of a linear problem depend on each other, or a mode grows so fast that the step
  // outruns it.
  Ending solve(Run& run, const StepEquations& step, Out y);

  // error becomes what an error of the equations does to their solution, about that of the last step solved:
  // (1 - kappa df/dy)^(-1) error.
  void respond(Vec& error) const { matrix_->solve(error); }

  // Between two steps: the path, and the matrix with whose factors the next step begins.
  void state(Archive& archive);

  // What solves with the matrix, where that is sparse; empty: it is not, or nothing has been solved.
  [[nodiscard]] std::string_view linear_solver() const { return matrix_->solver(); }

 private:
  bool solve_nonlinear(Run& run, const StepEquations& step, Out y);
  bool solve_linear(Run& run, const StepEquations& step, Out y);
  // From the continued path, of at least one step, with the kept factors; y is the result, or, where these do
  // not serve, as it was.
  bool iterate_kept(Run& run, const StepEquations& step, Out y);
  // The factors become those at near_, where f_ is f. False where the determinant has changed its sign.
  bool renew_factors(Run& run, const StepEquations& step);
  // Whether the equations hold at y as well as they can. f_ becomes f(t, y).
  bool leaves_rounding(Run& run, const StepEquations& step, In y);
  // The path of f, and of the unknowns of algebraic rows, is continued to y, and takes in a solution y.
  void continue_path(const StepEquations& step, Vec& y);
  void remember(const StepEquations& step, In y);
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
  // The matrix becomes that at y, where f_ is f, and rest what y leaves of the equations.
  void linearise(Run& run, const StepEquations& step, In y, Vec& rest);

  const Problem& problem_;
  double tolerance_;
  std::unique_ptr<NewtonMatrix> matrix_;
  Wear wear_;
  Extrapolation path_;
  int sign_ = 0;  // of the determinant at the last solution; 0: there was none
  Vec f_, increment_, near_;
  // Of a linear problem: the kappa for which the matrix is factorised, and whether it has a solution then.
  std::optional<Vec> factorised_for_;
  bool solvable_ = false;
  std::optional<OutrunGrowth> growth_;
  bool outruns_ = false;
};

}  // namespace fde
