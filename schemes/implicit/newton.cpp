#include "implicit/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fde {
namespace {

constexpr int most_iterations = 50;
constexpr int few_setbacks = 3;
constexpr double stagnation = 1e-10;

constexpr int most_pseudo_steps = 200;
constexpr double most_bend = 0.25;       // of the equations along a pseudo time step, relative
constexpr double newton_inverse = 1e-3;  // of a pseudo time step that is as good as one without end
constexpr double shortest_inverse = 1e9;

}  // namespace

NewtonSolver::NewtonSolver(const Problem& problem, double tolerance)
    : problem_(problem), tolerance_(tolerance), matrix_(make_newton_matrix(problem)) {}

bool NewtonSolver::solve(Run& run, const StepEquations& step, Out y) {
  if (linear(problem_)) return solve_linear(run, step, y);
  Vec near = y;
  if (iterate(run, step, y, few_setbacks)) return true;
  if (approach(run, step, near) && iterate(run, step, near, few_setbacks)) {
    y = near;
    return true;
  }
  return y.allFinite() && iterate(run, step, y, most_iterations);
}

bool NewtonSolver::solve_linear(Run& run, const StepEquations& step, Out y) {
  if (factorised_for_ != step.kappa) {
    factorised_for_ = step.kappa;
    solvable_ = matrix_->factorise_linear(step.kappa);
  }
  if (!solvable_) return false;
  Vec increment = residual(step, matrix_->rows(), run.rhs(step.t, y), y);
  matrix_->solve(increment);
  y += increment;
  ++*run.cost().newton_iterations;
  return y.allFinite();
}

bool NewtonSolver::iterate(Run& run, const StepEquations& step, Out y, int most_setbacks) {
  double last = std::numeric_limits<double>::infinity();
  int setbacks = 0;
  for (int iteration = 0; iteration < most_iterations && setbacks < most_setbacks; ++iteration) {
    Vec increment = linearise(run, step, y);
    matrix_->factorise_and_solve(increment);
    y += increment;
    ++*run.cost().newton_iterations;
    const double now = relative_size(matrix_->rows(), increment, y);
    if (std::isnan(now)) return false;
    if (now <= tolerance_ || (now >= last / 2 && now <= stagnation)) return true;
    if (now >= last) ++setbacks;
    last = now;
  }
  return false;
}

bool NewtonSolver::approach(Run& run, const StepEquations& step, Out y) {
  double inverse_step = 1.0;
  for (int work = 0; work < most_pseudo_steps && inverse_step < shortest_inverse; ++work) {
    Vec increment = linearise(run, step, y);
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
  Vec next = residual(step, rows, run.rhs(step.t, trial), trial);
  next -= inverse_step * rows.mass.cwiseProduct(increment);
  matrix_->solve(next);
  return next.lpNorm<Eigen::Infinity>() / increment.lpNorm<Eigen::Infinity>();
}

Vec NewtonSolver::linearise(Run& run, const StepEquations& step, In y) {
  const Vec f = run.rhs(step.t, y);
  matrix_->linearise(run, step, y, f);
  return residual(step, matrix_->rows(), f, y);
}

}  // namespace fde
