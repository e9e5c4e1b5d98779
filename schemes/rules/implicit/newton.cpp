// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/problem/componentwise.hpp"
#include "fdebench/schemes/problem/jacobian.hpp"

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

constexpr int most_sweeps = 8;
constexpr int most_pseudo_steps = 200;
constexpr double max_nonlinearity = 0.25;  // largest relative nonlinearity along a pseudo-time step
constexpr double newton_inverse = 1e-3;    // inverse of a pseudo-time step that counts as infinite
constexpr double shortest_inverse = 1e9;

}  // namespace

NewtonSolver::NewtonSolver(const Problem& problem, double tolerance)
    : problem_(problem),
      tolerance_(tolerance),
      matrix_(make_newton_matrix(problem)),
      jacobian_reuse_(static_cast<int>(2 * problem.size())),
      extrapolation_(problem.size()),
      f_(problem.size()),
      increment_(problem.size()),
      iterate_(problem.size()) {
  if (is_linear(problem)) growth_check_.emplace(problem);
}

SolveStatus NewtonSolver::solve(Run& run, const StepEquations& step, Out y) {
  const bool solved = growth_check_ ? solve_linear(run, step, y) : solve_nonlinear(run, step, y);
  if (step_too_large_) return SolveStatus::step_too_large;
  if (solved) return SolveStatus::finished;
  return y.allFinite() ? SolveStatus::not_converged : SolveStatus::non_finite;
}

bool NewtonSolver::solve_nonlinear(Run& run, const StepEquations& step, Out y) {
  const bool first = extrapolation_.empty();
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

bool NewtonSolver::iterate_with_kept_factors(Run& run, const StepEquations& step, Out y) {
  const auto& rows = matrix_->rows();
  iterate_ = y;
  extrapolate_guess(step, iterate_);
  for_each_component(y.size(), [&](Eigen::Index i) { increment_[i] = iterate_[i] - y[i]; });
  // The first increment is judged as if an increment of this size had led to the guess.
  double last = std::max(most_doubt * relative_norm(rows, increment_, iterate_), stagnation);
  bool recompute = jacobian_reuse_.is_stale(), fresh = recompute;  // fresh: factorised in this step
  f_ = run.rhs(step.t, iterate_);
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    if (recompute && !refactorise(run, step)) return false;
    compute_residual(step, rows, f_, iterate_, increment_);
    matrix_->solve(increment_);
    for_each_component(y.size(), [&](Eigen::Index i) { iterate_[i] += increment_[i]; });
    ++*run.cost().newton_iterations;
    const double now = relative_norm(rows, increment_, iterate_);
    const bool rounding = iteration > 1 && stagnates(now, last);
    if (!(now <= last / 2) && !rounding) return false;
    if (now <= tolerance_ || (rounding && fresh) || is_solved_to_rounding(run, step, iterate_)) {
      jacobian_reuse_.record_step(iteration);
      y = iterate_;
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

bool NewtonSolver::refactorise(Run& run, const StepEquations& step) {
  matrix_->linearise(run, step, iterate_, f_);
  matrix_->factorise();
  jacobian_reuse_.reset();
  const int before = std::exchange(determinant_sign_, matrix_->determinant_sign());
  return before == 0 || before == determinant_sign_;
}

bool NewtonSolver::is_solved_to_rounding(Run& run, const StepEquations& step, In y) {
  f_ = run.rhs(step.t, y);
  return matrix_->rows().algebraic.empty() && equations_hold(step, f_, y, part_of_tolerance * tolerance_);
}

void NewtonSolver::extrapolate_guess(const StepEquations& step, Vec& y) {
  extrapolation_.at(step.t, f_);
  for (const auto i : matrix_->rows().algebraic) y[i] = f_[i];
  const Vec& mass = matrix_->rows().mass;
  for_each_component(
      y.size(), [&](Eigen::Index i) { y[i] += mass[i] * (step.known[i] + step.kappa[i] * f_[i] - y[i]); });
}

void NewtonSolver::append_to_extrapolation(const StepEquations& step, In y) {
  for_each_component(y.size(), [&](Eigen::Index i) { f_[i] = (y[i] - step.known[i]) / step.kappa[i]; });
  for (const auto i : matrix_->rows().algebraic) f_[i] = y[i];
  extrapolation_.push(step.t, f_);
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

bool NewtonSolver::solve_linear(Run& run, const StepEquations& step, Out y) {
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
  f_ = run.rhs(step.t, y);
  for (int iteration = 0; iteration < most_iterations && setbacks < most_setbacks; ++iteration) {
    linearise(run, step, y, increment_);
    matrix_->factorise();
    matrix_->solve(increment_);
    y += increment_;
    ++*run.cost().newton_iterations;
    const double now = relative_norm(matrix_->rows(), increment_, y);
    if (std::isnan(now)) return false;
    if (now <= tolerance_ || stagnates(now, last) || is_solved_to_rounding(run, step, y)) return true;
    if (now >= last) ++setbacks;
    last = now;
  }
  return false;
}

bool NewtonSolver::pseudo_transient_continuation(Run& run, const StepEquations& step, Out y) {
  double inverse_step = 1.0;
  Vec increment(y.size());
  for (int work = 0; work < most_pseudo_steps && inverse_step < shortest_inverse; ++work) {
    f_ = run.rhs(step.t, y);
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
  archive(factorised, extrapolation_, jacobian_reuse_, determinant_sign_, growth_check_);
  if (!factorised) return;
  archive(matrix_);
  if (!growth_check_) return;
  if (!factorised_for_) factorised_for_ = Vec::Zero(problem_.size());
  archive(*factorised_for_, solvable_);
}

}  // namespace fde
