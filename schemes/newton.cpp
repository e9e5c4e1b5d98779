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

// x with A x = b in place of b. Most problems have a few components, where a size known to the compiler saves
// most of the time.
template <int size>
void solve_fixed(const Matrix& a, Vec& b) {
  const Eigen::Map<const Eigen::Matrix<double, size, size>> fixed(a.data());
  Eigen::Map<Eigen::Matrix<double, size, 1>> x(b.data());
  x = fixed.partialPivLu().solve(x).eval();
}
void solve_in_place(const Matrix& a, Vec& b) {
  switch (b.size()) {
    case 1:
      b /= a(0, 0);
      return;
    case 2:
      return solve_fixed<2>(a, b);
    case 3:
      return solve_fixed<3>(a, b);
    case 4:
      return solve_fixed<4>(a, b);
    default:
      b = a.partialPivLu().solve(b).eval();
  }
}

}  // namespace

void differentiate(Run& run, const Problem& problem, double t, In y, In f, OutMatrix jacobian) {
  if (problem.linear_part) {
    jacobian = *problem.linear_part;
  } else if (problem.jacobian) {
    problem.jacobian(t, y, jacobian);
  } else {
    difference(run, t, y, f, jacobian);
  }
}

NewtonSolver::NewtonSolver(const Problem& problem, double tolerance)
    : problem_(problem),
      kappa_(Vec::Zero(problem.size())),
      tolerance_(tolerance),
      jacobian_(problem.size(), problem.size()),
      f_(problem.size()),
      increment_(problem.size()) {}

bool NewtonSolver::solve(Run& run, double t, const Vec& kappa, In past, Out y) {
  if (kappa_ != kappa) {
    kappa_ = kappa;
    if (problem_.linear_part) factors_.compute(system(*problem_.linear_part));
  }
  if (problem_.linear_part) return solve_linear(run, t, past, y);
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    f_ = run.rhs(t, y);
    differentiate(run, t, y, f_);
    increment_ = past + kappa_.cwiseProduct(f_) - y;
    solve_in_place(jacobian_, increment_);
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

void NewtonSolver::differentiate(Run& run, double t, In y, In f) {
  fde::differentiate(run, problem_, t, y, f, jacobian_);
  jacobian_ = system(jacobian_);
}

Matrix NewtonSolver::system(const Matrix& jacobian) const {
  return Matrix::Identity(jacobian.rows(), jacobian.cols()) - kappa_.asDiagonal() * jacobian;
}

}  // namespace fde
