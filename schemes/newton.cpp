#include "newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fde {
namespace {

constexpr int most_iterations = 50;
constexpr double stagnation = 1e-10;

// Forward differences of rhs at y, where it is f.
void difference(Run& run, double t, In y, In f, OutMatrix jacobian) {
  const double relative_step = std::sqrt(std::numeric_limits<double>::epsilon());
  Vec shifted = y;
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    shifted[i] = y[i] + relative_step * std::max(std::abs(y[i]), 1.0);
    jacobian.col(i) = (run.rhs(t, shifted) - f) / (shifted[i] - y[i]);
    shifted[i] = y[i];
  }
}

}  // namespace

NewtonSolver::NewtonSolver(const Problem& problem, Vec kappa, double tolerance)
    : problem_(problem),
      kappa_(std::move(kappa)),
      tolerance_(tolerance),
      jacobian_(problem.size(), problem.size()),
      f_(problem.size()),
      increment_(problem.size()) {
  if (problem.linear_part) {
    jacobian_ = *problem.linear_part;
    factors_.compute(Matrix::Identity(problem.size(), problem.size()) - kappa_.asDiagonal() * jacobian_);
  }
}

bool NewtonSolver::solve(Run& run, double t, In past, Out y) {
  if (problem_.linear_part) return solve_linear(run, t, past, y);
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    f_ = run.rhs(t, y);
    factorise(run, t, y, f_);
    increment_ = factors_.solve(past + kappa_.cwiseProduct(f_) - y);
    y += increment_;
    ++run.cost().newton_iterations;
    const double size = y.lpNorm<Eigen::Infinity>(), now = increment_.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) return false;
    if (now <= tolerance_ * size || (now >= last / 2 && now <= stagnation * size)) return true;
    last = now;
  }
  return false;
}

bool NewtonSolver::solve_linear(Run& run, double t, In past, Out y) {
  f_ = run.rhs(t, y);
  y += factors_.solve(past + kappa_.cwiseProduct(f_) - y);
  ++run.cost().newton_iterations;
  return y.allFinite();
}

void NewtonSolver::factorise(Run& run, double t, In y, In f) {
  if (problem_.jacobian) {
    problem_.jacobian(t, y, jacobian_);
  } else {
    difference(run, t, y, f, jacobian_);
  }
  factors_.compute(Matrix::Identity(y.size(), y.size()) - kappa_.asDiagonal() * jacobian_);
}

}  // namespace fde
