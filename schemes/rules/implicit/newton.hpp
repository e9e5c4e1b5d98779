// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/rules/implicit/extrapolation.hpp"
#include "fdebench/schemes/rules/implicit/growth_check.hpp"
#include "fdebench/schemes/rules/implicit/newton_matrix.hpp"
#include "fdebench/schemes/stepping/run.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// Decides when factors that are reused from step to step are to be recomputed: once they have cost as many
// additional iterations, compared with fresh factors, as a new factorisation costs.
class JacobianReuse {
 public:
  // price: cost of a factorisation, in iterations.
  explicit JacobianReuse(int price) : factorisation_cost_(price) {}

  // Whether the factors are to be recomputed.
  [[nodiscard]] bool is_stale() const { return stale_; }
  // The factors have been recomputed.
  void reset() {
    stale_ = false;
    steps_ = iterations_ = min_iterations_ = 0;
  }
  // Records the number of iterations of a step.
  void record_step(long iterations) {
    min_iterations_ = steps_ == 0 ? iterations : std::min(min_iterations_, iterations);
    ++steps_;
    iterations_ += iterations;
    if (iterations_ - steps_ * min_iterations_ >= factorisation_cost_) stale_ = true;
  }

  void state(Archive& archive) { archive(steps_, iterations_, min_iterations_, stale_); }

 private:
  int factorisation_cost_;
  long steps_ = 0, iterations_ = 0, min_iterations_ = 0;
  bool stale_ = true;
};

// Solves y_i = known_i + kappa_i f_i(t, y), and 0 = f_i(t, y) in algebraic rows, for y, at every step of one
// run.
//
// A linear problem with matrix A is solved with one factorisation of I - kappa A as long as kappa does not
// change. Otherwise Newton's method uses the Jacobian of the problem, or differences of rhs where it has
// none. A step ends where the last increment is below tolerance * |y|, or has stopped shrinking below 1e-10 *
// |y|, where rounding dominates. Without algebraic rows it also ends where every equation holds to a quarter
// of the tolerance, relative to its terms known_i and kappa_i f_i: this test costs one evaluation of f, less
// than another iteration. The ratio of successive increments is no substitute: a component that is small
// beside the others does not show in it.
//
// The initial guess is y = known + kappa f, with f extrapolated from the last steps (Extrapolation). Without
// algebraic rows it is the solution where every equation holds with it to a quarter of the tolerance, or of
// the default tolerance if that is smaller: where the solution is smooth, a step takes one evaluation of f
// and no iteration. Otherwise the iteration starts from it where the first increment is at most a tenth of
// its distance from the step before. The factorised matrix is reused from step to step. It is recomputed at
// the iterate where an increment is more than a twentieth of the one before, or where reuse has become too
// expensive (JacobianReuse). The guess is rejected where increments do not halve, and where the determinant
// of a new matrix differs in sign from that at the last solution: two solutions that meet and vanish (as
// those of y = known + kappa y^2, before y is infinite) differ in this sign.
//
// After a rejected guess the iteration restarts from the y that was passed, the solution at the step before,
// with a new matrix in each iteration. Where three increments are no smaller than those before them, as when
// the solution near the guess has just vanished, it restarts from the result of pseudo-time steps. If these
// fail, it continues from its last iterate. Where derivatives at the guess are not finite, as the derivative
// of y^(1/6) at 0, it starts from y = known + kappa f(t, guess), up to eight times.
//
// At the first step of a problem without algebraic rows, a negative determinant ends the run: the determinant
// is positive for short enough steps, so the step is longer than one at which a solution vanishes or a
// growing mode becomes singular.
//
// With algebraic rows, |y| is the largest of the other unknowns. An unknown lambda_i of an algebraic row is
// measured by its effect on the equations, max_k |M_ki| |lambda_i| with M the iteration matrix, relative to
// |y| or, where it is larger, to itself. That is about |lambda_i| where its own row determines it. A
// multiplier, which enters other rows with the factor kappa only, is measured with this factor: rounding /
// kappa is the best possible accuracy of it, and no more is required. The error that the last increment
// leaves in a constraint is of second order in that increment, or rounding.
class NewtonSolver {
 public:
  // tolerance: relative, see above. The problem must outlive the solver.
  NewtonSolver(const Problem& problem, double tolerance);

  // Replaces y, the solution at the step before, by the solution. The result is not SolveStatus::finished if
  // 350 iterations do not suffice, a value is not finite, the constraints of a linear problem are dependent,
  // or the step is too large for a growing mode. Where f jumps at the end of the step, the equations are
  // solved with f before the jump as well.
  SolveStatus solve(Run& run, const StepEquations& step, Out y);

  // The value that the last step delivers: its solution y or, where f jumps at its end, the solution with f
  // before the jump.
  [[nodiscard]] const Vec& delivered(const Vec& y) const { return before_jump_ ? *before_jump_ : y; }

  // f(t, y) at the solution y of the last solve(); evaluated only where solve() has not. The reference is
  // valid until the next call.
  const Vec& rhs_at_solution(Run& run, double t, In y);

  // Replaces an error of the equations by its effect on the solution, (1 - kappa df/dy)^(-1) error. The
  // matrix is about that of the last step solved.
  void apply_inverse(Vec& error) const { matrix_->solve(error); }

  // Saves or restores the state between two steps: the values to extrapolate, and the matrix with whose
  // factors the next step begins.
  void state(Archive& archive);

  // The solver of a sparse matrix; empty: the matrix is dense, or nothing has been solved.
  [[nodiscard]] std::string_view linear_solver() const { return matrix_->solver(); }

 private:
  // Sets before_jump_, from y, the solution at the step before.
  bool solve_before_jump(Run& run, const StepEquations& step, In y);
  bool solve_nonlinear(Run& run, const StepEquations& step, Out& y);
  bool solve_linear(Run& run, const StepEquations& step, Out& y);
  // Iterates from iterate_, the guess, with the kept factors; f_ is f there. Returns false, with y unchanged,
  // where the guess or the factors are rejected.
  bool iterate_with_kept_factors(Run& run, const StepEquations& step, Out& y);
  // Factorises the matrix at iterate_, where f_ is f. Returns false where the determinant has changed its
  // sign.
  bool refactorise(Run& run, const StepEquations& step);
  // Adds J increment_ to f_, J the Jacobian of the factors: f_ is then f at iterate_, up to a part of the
  // last increment. Precondition: the increment is at most unseen_.
  void add_increment_of_rhs(const StepEquations& step);
  // Whether the equations hold at y up to a part of the tolerance, also stored in f_is_at_solution_. Sets f_
  // to f(t, y).
  bool is_solved_to(double tolerance, Run& run, const StepEquations& step, In y);
  // Sets iterate_ to known + kappa f with f extrapolated, and to extrapolated unknowns of algebraic rows;
  // append_to_extrapolation() adds the values at a solution y.
  void extrapolate_guess(const StepEquations& step);
  void append_to_extrapolation(const StepEquations& step, In y);
  // Selects the number of points that would have given the best guess of y.
  void choose_points_to_extrapolate_from(const StepEquations& step, In y);
  // Newton's method from y with a new matrix in each iteration; where it fails, from the result of
  // pseudo-time steps, or from y = known + kappa f where y has no finite derivatives.
  bool iterate_from_previous(Run& run, const StepEquations& step, Out y);
  // Where the derivatives at y are not finite: Newton's method from y = known + kappa f(t, y), repeatedly. y
  // is NaN where it fails.
  bool iterate_past_infinite_derivatives(Run& run, const StepEquations& step, Out y);
  // Newton's method from y. It fails after most_setbacks increments that are no smaller than the one before.
  bool iterate(Run& run, const StepEquations& step, Out y, int most_setbacks);
  // Brings y so close to a solution that Newton's method should converge: pseudo-transient continuation, mass
  // y' = known + kappa f(t, y) - y by linearly implicit Euler steps (Kelley & Keyes, SIAM J. Numer. Anal. 35
  // (1998)). The steps grow where the equations are nearly linear along them; an infinite step is a step of
  // Newton's method.
  bool pseudo_transient_continuation(Run& run, const StepEquations& step, Out y);
  // Nonlinearity of the equations along an increment of a pseudo-time step: the next increment relative to
  // it.
  double nonlinearity(Run& run, const StepEquations& step, In y, const Vec& increment, double inverse_step);
  // Computes the matrix at y, where f_ is f, and the residual.
  void linearise(Run& run, const StepEquations& step, In y, Vec& rest);

  const Problem& problem_;
  double tolerance_;
  // What may remain of an equation, or of an increment, without another evaluation of f: rounding at most,
  // also where the tolerance is larger. The memory term would take what is missed for f, and add it up.
  double unseen_;
  std::unique_ptr<NewtonMatrix> matrix_;
  JacobianReuse jacobian_reuse_;
  Extrapolation extrapolation_;
  int determinant_sign_ = 0;  // sign of the determinant at the last solution; 0: there was none
  Vec f_, increment_, residual_, iterate_;
  std::optional<Vec> before_jump_{};  // the solution of the last step with f before the jump at its end
  int missed_guesses_ = 0;         // extrapolated guesses that were not the solution, since the last choice
  bool f_is_at_solution_ = false;  // f_ is f(t, y) at the result of the last solve()
  // Of a linear problem: the kappa for which the matrix is factorised, and whether the equations can be
  // solved.
  std::optional<Vec> factorised_for_;
  bool solvable_ = false;
  std::optional<GrowthCheck> growth_check_;
  bool step_too_large_ = false;
};

}  // namespace fde
