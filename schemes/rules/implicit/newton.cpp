// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {
namespace {

constexpr int most_iterations = 50;
constexpr int few_setbacks = 3;
constexpr double stagnation = 1e-10;

constexpr double part_of_tolerance = 0.25;  // residual of an equation relative to its terms
constexpr double slowest = 0.05;            // an increment with kept factors, relative to the one before
constexpr double most_doubt = 0.2;          // twice the first increment, relative to guess - previous y

// Whether increments no longer shrink, and are so small that rounding is the reason.
bool stagnates(double now, double last) { return now >= last / 2 && now <= stagnation; }

constexpr int misses_between_choices = 8;  // of the number of points to extrapolate from

constexpr int most_sweeps = 8;
constexpr int most_pseudo_steps = 200;
constexpr double max_nonlinearity = 0.25;  // largest relative nonlinearity along a pseudo-time step
constexpr double newton_inverse = 1e-3;    // inverse of a pseudo-time step that counts as infinite
constexpr double shortest_inverse = 1e9;

}  // namespace

NewtonSolver::NewtonSolver(const Problem& problem, double tolerance)
    : problem_(problem),
      tolerance_(tolerance),
      unseen_(std::min(tolerance, Options{}.newton_tolerance)),
      matrix_(make_newton_matrix(problem)),
      jacobian_reuse_(static_cast<int>(2 * problem.size())),
      extrapolation_(problem.size()),
      f_(problem.size()),
      increment_(problem.size()),
      residual_(problem.size()),
      iterate_(problem.size()) {
  if (is_linear(problem)) growth_check_.emplace(problem);
}

SolveStatus NewtonSolver::solve(Run& run, const StepEquations& step, Out y) {
  before_jump_.reset();
  bool solved = !step.before_jump || solve_before_jump(run, step, y);
  f_is_at_solution_ = false;
  if (solved) solved = growth_check_ ? solve_linear(run, step, y) : solve_nonlinear(run, step, y);
  if (step_too_large_) return SolveStatus::step_too_large;
  if (solved) return SolveStatus::finished;
  return y.allFinite() ? SolveStatus::not_converged : SolveStatus::non_finite;
}

bool NewtonSolver::solve_before_jump(Run& run, const StepEquations& step, In y) {
  const StepEquations before{*step.before_jump, step.kappa, step.known};
  Eigen::Ref<Vec> solution = before_jump_.emplace(y);
  if (growth_check_) return solve_linear(run, before, solution);
  jacobian_reuse_.reset();
  return iterate_from_previous(run, before, solution);
}

bool NewtonSolver::solve_nonlinear(Run& run, const StepEquations& step, Out& y) {
  const bool first = extrapolation_.empty();
  if (!first) {
    extrapolate_guess(step);
    if (is_solved_to(unseen_, run, step, iterate_)) {
      extrapolation_.push(step.t, f_);
      copy_rows(y.size(), iterate_.data(), y.data());
      return true;
    }
    ++missed_guesses_;
  }
  if (first || !iterate_with_kept_factors(run, step, y)) {
    if (!iterate_from_previous(run, step, y)) return false;
    // The factors are from the last iteration, which began close to y.
    jacobian_reuse_.reset();
    determinant_sign_ = matrix_->determinant_sign();
    step_too_large_ = first && determinant_sign_ < 0 && matrix_->rows().algebraic.empty();
  }
  append_to_extrapolation(step, y);
  return true;
}

bool NewtonSolver::iterate_with_kept_factors(Run& run, const StepEquations& step, Out& y) {
  const auto& rows = matrix_->rows();
  for_each_row(y.size(), [&](Eigen::Index i) { increment_[i] = iterate_[i] - y[i]; });
  // The first increment is judged as if an increment of this size had led to the guess.
  double last = std::max(most_doubt * relative_norm(rows, increment_, iterate_), stagnation);
  bool recompute = jacobian_reuse_.is_stale(), fresh = recompute;  // fresh: factorised in this step
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    if (recompute && !refactorise(run, step)) return false;
    compute_residual(step, rows, f_, iterate_, residual_);
    copy_rows(y.size(), residual_.data(), increment_.data());
    matrix_->solve(increment_);
    for_each_row(y.size(), [&](Eigen::Index i) { iterate_.coeffRef(i) += increment_.coeff(i); });
    ++*run.cost().newton_iterations;
    const double now = relative_norm(rows, increment_, iterate_);
    const bool rounding = iteration > 1 && stagnates(now, last);
    if (!(now <= last / 2) && !rounding) return false;
    if (now <= unseen_) add_increment_of_rhs(step);
    if (now <= tolerance_ || (rounding && fresh) || is_solved_to(tolerance_, run, step, iterate_)) {
      jacobian_reuse_.record_step(iteration);
      copy_rows(y.size(), iterate_.data(), y.data());
      return true;
    }
    const bool slow = iteration > 1 && now > slowest * last;
    if (slow && recompute && !rounding) return false;
    recompute = rounding || slow;
    fresh = fresh || recompute;
    last = now;
  }
  return false;
}

// The increment d solves d - kappa J d = residual.
void NewtonSolver::add_increment_of_rhs(const StepEquations& step) {
  if (!matrix_->rows().algebraic.empty()) return;
  for_each_row(f_.size(), [&](Eigen::Index i) {
    f_.coeffRef(i) += (increment_.coeff(i) - residual_.coeff(i)) / step.kappa.coeff(i);
  });
  f_is_at_solution_ = true;
}

bool NewtonSolver::refactorise(Run& run, const StepEquations& step) {
  matrix_->linearise(run, step, iterate_, f_);
  matrix_->factorise();
  jacobian_reuse_.reset();
  const int before = std::exchange(determinant_sign_, matrix_->determinant_sign());
  return before == 0 || before == determinant_sign_;
}

bool NewtonSolver::is_solved_to(double tolerance, Run& run, const StepEquations& step, In y) {
  run.rhs(step.t, y, f_);
  f_is_at_solution_ =
      matrix_->rows().algebraic.empty() && equations_hold(step, f_, y, part_of_tolerance * tolerance);
  return f_is_at_solution_;
}

const Vec& NewtonSolver::rhs_at_solution(Run& run, double t, In y) {
  if (!f_is_at_solution_) run.rhs(t, y, f_);
  return f_;
}

void NewtonSolver::extrapolate_guess(const StepEquations& step) {
  extrapolation_.at(step.t, iterate_);
  for_each_row(iterate_.size(), [y = iterate_.data(), known = step.known.data(), kappa = step.kappa.data(),
                                 mass = matrix_->rows().mass.data()](Eigen::Index i) {
    if (mass[i] != 0.0) y[i] = known[i] + kappa[i] * y[i];
  });
}

// The rounding errors of y change f by df/dy times them, and the quotient by 1 / kappa times them. Where the
// equation holds with f, f is the more accurate one.
void NewtonSolver::append_to_extrapolation(const StepEquations& step, In y) {
  for_each_row(y.size(), [&, f = f_.data(), value = increment_.data(),
                          limit = part_of_tolerance * tolerance_](Eigen::Index i) {
    const double known = step.known.coeff(i), kappa = step.kappa.coeff(i);
    const bool holds = equation_holds(known, kappa * f[i], y.coeff(i), limit);
    value[i] = holds ? f[i] : (y.coeff(i) - known) / kappa;
  });
  for (const auto i : matrix_->rows().algebraic) increment_[i] = y[i];
  if (missed_guesses_ == misses_between_choices) choose_points_to_extrapolate_from(step, y);
  extrapolation_.push(step.t, increment_);
}

void NewtonSolver::choose_points_to_extrapolate_from(const StepEquations& step, In y) {
  const Vec& mass = matrix_->rows().mass;
  const Vec scale = Vec::NullaryExpr(y.size(), [&](Eigen::Index i) {
    const double effect = mass[i] == 0.0 ? 1.0 : step.kappa[i];
    return y[i] == 0.0 ? 0.0 : effect / std::abs(y[i]);
  });
  extrapolation_.choose_count(step.t, increment_, scale);
  missed_guesses_ = 0;
}

bool NewtonSolver::iterate_from_previous(Run& run, const StepEquations& step, Out y) {
  const Vec guess = y;
  Vec near = y;
  if (iterate(run, step, y, few_setbacks)) return true;
  if (pseudo_transient_continuation(run, step, near) && iterate(run, step, near, few_setbacks)) {
    y = near;
    return true;
  }
  if (y.allFinite()) return iterate(run, step, y, most_iterations);
  y = guess;
  return iterate_past_infinite_derivatives(run, step, y);
}

bool NewtonSolver::iterate_past_infinite_derivatives(Run& run, const StepEquations& step, Out y) {
  const auto failed = [&] {
    y.setConstant(std::numeric_limits<double>::quiet_NaN());
    return false;
  };
  if (jacobian_at(problem_, step.t, y).allFinite()) return failed();
  const Vec& mass = matrix_->rows().mass;
  for (int sweep = 0; sweep < most_sweeps && y.allFinite(); ++sweep) {
    y += mass.cwiseProduct(step.known + step.kappa.cwiseProduct(run.rhs(step.t, y)) - y);
    Vec near = y;
    if (!iterate(run, step, near, few_setbacks)) continue;
    y = near;
    return true;
  }
  return failed();
}

bool NewtonSolver::solve_linear(Run& run, const StepEquations& step, Out& y) {
  const auto is_factorised = [&] {
    return holds_for_each_row(y.size(),
                              [&](Eigen::Index i) { return (*factorised_for_)[i] == step.kappa[i]; });
  };
  if (!factorised_for_ || !is_factorised()) {
    factorised_for_ = step.kappa;
    solvable_ = matrix_->factorise_linear(step.kappa);
    step_too_large_ = growth_check_->is_step_too_large(*matrix_, step.kappa, solvable_);
  }
  if (!solvable_ || step_too_large_) return false;
  compute_residual(step, matrix_->rows(), run.rhs(step.t, y), y, increment_);
  matrix_->solve(increment_);
  for_each_row(y.size(), [&](Eigen::Index i) { y[i] += increment_[i]; });
  ++*run.cost().newton_iterations;
  return true;  // Run::accept looks at y
}

bool NewtonSolver::iterate(Run& run, const StepEquations& step, Out y, int most_setbacks) {
  double last = std::numeric_limits<double>::infinity();
  int setbacks = 0;
  run.rhs(step.t, y, f_);
  for (int iteration = 0; iteration < most_iterations && setbacks < most_setbacks; ++iteration) {
    linearise(run, step, y, increment_);
    matrix_->factorise();
    matrix_->solve(increment_);
    y += increment_;
    ++*run.cost().newton_iterations;
    const double now = relative_norm(matrix_->rows(), increment_, y);
    if (std::isnan(now)) return false;
    if (now <= tolerance_ || stagnates(now, last) || is_solved_to(tolerance_, run, step, y)) return true;
    if (now >= last) ++setbacks;
    last = now;
  }
  return false;
}

bool NewtonSolver::pseudo_transient_continuation(Run& run, const StepEquations& step, Out y) {
  double inverse_step = 1.0;
  Vec increment(y.size());
  for (int work = 0; work < most_pseudo_steps && inverse_step < shortest_inverse; ++work) {
    run.rhs(step.t, y, f_);
    linearise(run, step, y, increment);
    matrix_->add_to_diagonal(inverse_step * matrix_->rows().mass);
    matrix_->factorise();
    matrix_->solve(increment);
    ++*run.cost().newton_iterations;
    const double bent = nonlinearity(run, step, y, increment, inverse_step);
    if (!(bent <= max_nonlinearity)) {
      inverse_step *= 4.0;
      continue;
    }
    y += increment;
    if (inverse_step < newton_inverse) return true;
    inverse_step *= std::max(bent / max_nonlinearity, 0.1);
  }
  return false;
}

double NewtonSolver::nonlinearity(Run& run, const StepEquations& step, In y, const Vec& increment,
                                  double inverse_step) {
  const auto& rows = matrix_->rows();
  const Vec trial = y + increment;
  Vec next(y.size());
  compute_residual(step, rows, run.rhs(step.t, trial), trial, next);
  next -= inverse_step * rows.mass.cwiseProduct(increment);
  matrix_->solve(next);
  return next.lpNorm<Eigen::Infinity>() / increment.lpNorm<Eigen::Infinity>();
}

void NewtonSolver::linearise(Run& run, const StepEquations& step, In y, Vec& rest) {
  matrix_->linearise(run, step, y, f_);
  compute_residual(step, matrix_->rows(), f_, y, rest);
}

void NewtonSolver::state(Archive& archive) {
  bool factorised = factorised_for_ || !extrapolation_.empty();
  archive(factorised, extrapolation_, missed_guesses_, f_is_at_solution_, jacobian_reuse_, determinant_sign_,
          growth_check_);
  if (f_is_at_solution_) archive(f_);
  if (!factorised) return;
  archive(matrix_);
  if (!growth_check_) return;
  if (!factorised_for_) factorised_for_ = Vec::Zero(problem_.size());
  archive(*factorised_for_, solvable_);
}

}  // namespace fde
