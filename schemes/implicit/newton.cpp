#include "implicit/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "problem/componentwise.hpp"
#include "problem/jacobian.hpp"

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
constexpr double most_bend = 0.25;       // largest relative nonlinearity along a pseudo-time step
constexpr double newton_inverse = 1e-3;  // inverse of a pseudo-time step that counts as infinite
constexpr double shortest_inverse = 1e9;

}  // namespace

NewtonSolver::NewtonSolver(const Problem& problem, double tolerance)
    : problem_(problem),
      tolerance_(tolerance),
      matrix_(make_newton_matrix(problem)),
      wear_(static_cast<int>(2 * problem.size())),
      path_(problem.size()),
      f_(problem.size()),
      increment_(problem.size()),
      near_(problem.size()) {
  if (linear(problem)) growth_.emplace(problem);
}

Ending NewtonSolver::solve(Run& run, const StepEquations& step, Out y) {
  const bool solved = growth_ ? solve_linear(run, step, y) : solve_nonlinear(run, step, y);
  if (outruns_) return Ending::outran_growth;
  if (solved) return Ending::finished;
  return y.allFinite() ? Ending::not_converged : Ending::not_finite;
}

bool NewtonSolver::solve_nonlinear(Run& run, const StepEquations& step, Out y) {
  const bool first = path_.empty();
  if (first || !iterate_kept(run, step, y)) {
    if (!iterate_anew(run, step, y)) return false;
    // The factors are from the last iteration, which began close to y.
    wear_.renew();
    sign_ = matrix_->determinant_sign();
    outruns_ = first && sign_ < 0 && matrix_->rows().algebraic.empty();
  }
  remember(step, y);
  return true;
}

bool NewtonSolver::iterate_kept(Run& run, const StepEquations& step, Out y) {
  const auto& rows = matrix_->rows();
  near_ = y;
  continue_path(step, near_);
  for_each_component(y.size(), [&](Eigen::Index i) { increment_[i] = near_[i] - y[i]; });
  // The first increment is judged as if an increment of this size had led to the guess.
  double last = std::max(most_doubt * relative_size(rows, increment_, near_), stagnation);
  bool anew = wear_.worn(), fresh = anew;  // fresh: factorised in this step
  f_ = run.rhs(step.t, near_);
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    if (anew && !renew_factors(run, step)) return false;
    take_residual(step, rows, f_, near_, increment_);
    matrix_->solve(increment_);
    for_each_component(y.size(), [&](Eigen::Index i) { near_[i] += increment_[i]; });
    ++*run.cost().newton_iterations;
    const double now = relative_size(rows, increment_, near_);
    const bool rounding = iteration > 1 && stagnates(now, last);
    if (!(now <= last / 2) && !rounding) return false;
    if (now <= tolerance_ || (rounding && fresh) || leaves_rounding(run, step, near_)) {
      wear_.count(iteration);
      y = near_;
      return true;
    }
    const bool slow = iteration > 1 && now > slowest * last;
    if (slow && anew && !rounding) return false;
    anew = rounding || slow;
    fresh = fresh || anew;
    last = now;
  }
  return false;
}

bool NewtonSolver::renew_factors(Run& run, const StepEquations& step) {
  matrix_->linearise(run, step, near_, f_);
  matrix_->factorise();
  wear_.renew();
  const int before = std::exchange(sign_, matrix_->determinant_sign());
  return before == 0 || before == sign_;
}

bool NewtonSolver::leaves_rounding(Run& run, const StepEquations& step, In y) {
  f_ = run.rhs(step.t, y);
  return matrix_->rows().algebraic.empty() && holds(step, f_, y, part_of_tolerance * tolerance_);
}

void NewtonSolver::continue_path(const StepEquations& step, Vec& y) {
  path_.at(step.t, f_);
  for (const auto i : matrix_->rows().algebraic) y[i] = f_[i];
  const Vec& mass = matrix_->rows().mass;
  for_each_component(
      y.size(), [&](Eigen::Index i) { y[i] += mass[i] * (step.past[i] + step.kappa[i] * f_[i] - y[i]); });
}

void NewtonSolver::remember(const StepEquations& step, In y) {
  for_each_component(y.size(), [&](Eigen::Index i) { f_[i] = (y[i] - step.past[i]) / step.kappa[i]; });
  for (const auto i : matrix_->rows().algebraic) f_[i] = y[i];
  path_.push(step.t, f_);
}

bool NewtonSolver::iterate_anew(Run& run, const StepEquations& step, Out y) {
  const Vec guess = y;
  Vec near = y;
  if (iterate(run, step, y, few_setbacks)) return true;
  if (approach(run, step, near) && iterate(run, step, near, few_setbacks)) {
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
    y += mass.cwiseProduct(step.past + step.kappa.cwiseProduct(run.rhs(step.t, y)) - y);
    Vec near = y;
    if (!iterate(run, step, near, few_setbacks)) continue;
    y = near;
    return true;
  }
  return failed();
}

bool NewtonSolver::solve_linear(Run& run, const StepEquations& step, Out y) {
  if (factorised_for_ != step.kappa) {
    factorised_for_ = step.kappa;
    solvable_ = matrix_->factorise_linear(step.kappa);
    outruns_ = growth_->outruns(*matrix_, step.kappa, solvable_);
  }
  if (!solvable_ || outruns_) return false;
  take_residual(step, matrix_->rows(), run.rhs(step.t, y), y, increment_);
  matrix_->solve(increment_);
  y += increment_;
  ++*run.cost().newton_iterations;
  return y.allFinite();
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
    const double now = relative_size(matrix_->rows(), increment_, y);
    if (std::isnan(now)) return false;
    if (now <= tolerance_ || stagnates(now, last) || leaves_rounding(run, step, y)) return true;
    if (now >= last) ++setbacks;
    last = now;
  }
  return false;
}

bool NewtonSolver::approach(Run& run, const StepEquations& step, Out y) {
  double inverse_step = 1.0;
  Vec increment(y.size());
  for (int work = 0; work < most_pseudo_steps && inverse_step < shortest_inverse; ++work) {
    f_ = run.rhs(step.t, y);
    linearise(run, step, y, increment);
    matrix_->add_to_diagonal(inverse_step * matrix_->rows().mass);
    matrix_->factorise();
    matrix_->solve(increment);
    ++*run.cost().newton_iterations;
    const double bent = bend(run, step, y, increment, inverse_step);
    if (!(bent <= most_bend)) {
      inverse_step *= 4.0;
      continue;
    }
    y += increment;
    if (inverse_step < newton_inverse) return true;
    inverse_step *= std::max(bent / most_bend, 0.1);
  }
  return false;
}

double NewtonSolver::bend(Run& run, const StepEquations& step, In y, const Vec& increment,
                          double inverse_step) {
  const auto& rows = matrix_->rows();
  const Vec trial = y + increment;
  Vec next(y.size());
  take_residual(step, rows, run.rhs(step.t, trial), trial, next);
  next -= inverse_step * rows.mass.cwiseProduct(increment);
  matrix_->solve(next);
  return next.lpNorm<Eigen::Infinity>() / increment.lpNorm<Eigen::Infinity>();
}

void NewtonSolver::linearise(Run& run, const StepEquations& step, In y, Vec& rest) {
  matrix_->linearise(run, step, y, f_);
  take_residual(step, matrix_->rows(), f_, y, rest);
}

void NewtonSolver::state(Archive& archive) {
  bool factorised = factorised_for_ || !path_.empty();
  archive(factorised, path_, wear_, sign_, growth_);
  if (!factorised) return;
  archive(matrix_);
  if (!growth_) return;
  if (!factorised_for_) factorised_for_ = Vec::Zero(problem_.size());
  archive(*factorised_for_, solvable_);
}

}  // namespace fde
