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
    : problem_(problem),
      given_kappa_(Vec::Constant(problem.size(), std::numeric_limits<double>::quiet_NaN())),
      kappa_(given_kappa_),
      tolerance_(tolerance),
      matrix_(problem),
      f_(problem.size()),
      increment_(problem.size()) {}

bool NewtonSolver::solve(Run& run, double t, const Vec& kappa, In past, Out y) {
  if (given_kappa_ != kappa) {
    given_kappa_ = kappa_ = kappa;
    if (linear(problem_)) {
      matrix_.update(kappa_);
      matrix_.factorise();
      if (!matrix_.algebraic_rows().empty()) singular_ = matrix_.singular();
    }
  }
  if (linear(problem_)) return solve_linear(run, t, past, y);
  Vec near = y;
  if (iterate(run, t, past, y, few_setbacks)) return true;
  if (approach(run, t, past, near) && iterate(run, t, past, near, few_setbacks)) {
    y = near;
    return true;
  }
  return y.allFinite() && iterate(run, t, past, y, most_iterations);
}

bool NewtonSolver::iterate(Run& run, double t, In past, Out y, int most_setbacks) {
  double last = std::numeric_limits<double>::infinity();
  int setbacks = 0;
  for (int iteration = 0; iteration < most_iterations && setbacks < most_setbacks; ++iteration) {
    linearise(run, t, past, y);
    matrix_.factorise_and_solve(increment_);
    y += increment_;
    ++*run.cost().newton_iterations;
    const double now = relative_increment(y);
    if (std::isnan(now)) return false;
    if (now <= tolerance_ || (now >= last / 2 && now <= stagnation)) return true;
    if (now >= last) ++setbacks;
    last = now;
  }
  return false;
}

bool NewtonSolver::approach(Run& run, double t, In past, Out y) {
  double inverse_step = 1.0;
  Vec trial, increment;
  for (int work = 0; work < most_pseudo_steps && inverse_step < shortest_inverse; ++work) {
    linearise(run, t, past, y);
    matrix_.add_to_diagonal(inverse_step * matrix_.mass());
    matrix_.factorise();
    matrix_.solve(increment_);
    ++*run.cost().newton_iterations;
    increment = increment_;
    trial = y + increment;
    f_ = run.rhs(t, trial);
    take_residual(past, trial);
    increment_ -= inverse_step * matrix_.mass().cwiseProduct(increment);
    matrix_.solve(increment_);
    const double bend = increment_.lpNorm<Eigen::Infinity>() / increment.lpNorm<Eigen::Infinity>();
    if (!(bend <= most_bend)) {
      inverse_step *= 4.0;
      continue;
    }
    y = trial;
    if (inverse_step < newton_inverse) return true;
    inverse_step *= std::max(bend / most_bend, 0.1);
  }
  return false;
}

double NewtonSolver::relative_increment(In y) const {
  // Below, doubles lose their digits one by one: rounding is relative to this then.
  static constexpr double smallest =
      std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  const auto of = [](double increment, double size) { return increment / std::max(size, smallest); };
  const double size = matrix_.mass().cwiseProduct(y).lpNorm<Eigen::Infinity>();
  double largest = of(matrix_.mass().cwiseProduct(increment_).lpNorm<Eigen::Infinity>(), size);
  for (const auto i : matrix_.algebraic_rows()) {
    const double weight = matrix_.column_size(i);
    const double relative = of(weight * std::abs(increment_[i]), std::max(size, weight * std::abs(y[i])));
    if (!(relative <= largest)) largest = relative;
  }
  return largest;
}

bool NewtonSolver::solve_linear(Run& run, double t, In past, Out y) {
  if (singular_) return false;
  f_ = run.rhs(t, y);
  take_residual(past, y);
  matrix_.solve(increment_);
  y += increment_;
  ++*run.cost().newton_iterations;
  return y.allFinite();
}

void NewtonSolver::linearise(Run& run, double t, In past, In y) {
  f_ = run.rhs(t, y);
  const Vec sizes = past.cwiseAbs().cwiseMax(kappa_.cwiseProduct(f_).cwiseAbs()).cwiseProduct(matrix_.mass());
  matrix_.update(run, t, y, f_, sizes, kappa_);
  take_residual(past, y);
}

void NewtonSolver::take_residual(In past, In y) {
  increment_ = past + kappa_.cwiseProduct(f_) - y;
  for (const auto i : matrix_.algebraic_rows()) increment_[i] = kappa_[i] * f_[i];
}

}  // namespace fde
