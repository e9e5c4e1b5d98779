#include "newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "differences.hpp"

namespace fde {
namespace {

constexpr int most_iterations = 50;
constexpr int few_setbacks = 3;  // increments that are no smaller than the one before
constexpr double stagnation = 1e-10;

constexpr int most_pseudo_steps = 200;
constexpr double most_bend = 0.25;       // of a pseudo time step
constexpr double newton_inverse = 1e-3;  // of a pseudo time step so long that Newton's method takes over
constexpr double shortest_inverse = 1e9;

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

// Whether rounding decides about the solution, in whatever units the equations and unknowns are.
bool singular(Matrix a) {
  constexpr double rounding = 1e-14;
  const Vec rows = a.rowwise().lpNorm<Eigen::Infinity>();
  a.array().colwise() /= rows.array();
  const Eigen::RowVectorXd columns = a.colwise().lpNorm<Eigen::Infinity>();
  a.array().rowwise() /= columns.array();
  Eigen::FullPivLU<Matrix> factors(a);
  factors.setThreshold(rounding);
  return !factors.isInvertible();
}

}  // namespace

void differentiate(Run& run, const Problem& problem, double t, In y, In f, In sizes, OutMatrix jacobian) {
  if (problem.linear_part) {
    jacobian = *problem.linear_part;
  } else if (problem.jacobian) {
    problem.jacobian(t, y, jacobian);
  } else {
    forward_differences([&](const Vec& shifted) -> const Vec& { return run.rhs(t, shifted); }, y, f, sizes,
                        jacobian);
  }
}

NewtonSolver::NewtonSolver(const Problem& problem, double tolerance)
    : problem_(problem),
      mass_(Vec::Ones(problem.size())),
      given_kappa_(Vec::Zero(problem.size())),
      kappa_(given_kappa_),
      tolerance_(tolerance),
      matrix_(problem.size(), problem.size()),
      f_(problem.size()),
      increment_(problem.size()) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (!algebraic(problem.components[static_cast<std::size_t>(i)])) continue;
    algebraic_.push_back(i);
    mass_[i] = 0.0;
  }
}

bool NewtonSolver::solve(Run& run, double t, const Vec& kappa, In past, Out y) {
  if (given_kappa_ != kappa) {
    given_kappa_ = kappa_ = kappa;
    if (problem_.linear_part) factorise();
  }
  if (problem_.linear_part) return solve_linear(run, t, past, y);
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
    f_ = run.rhs(t, y);
    differentiate(run, t, past, y);
    take_residual(past, y);
    solve_in_place(matrix_, increment_);
    y += increment_;
    ++run.cost().newton_iterations;
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
  Vec trial, increment, rest;
  for (int work = 0; work < most_pseudo_steps && inverse_step < shortest_inverse; ++work) {
    f_ = run.rhs(t, y);
    differentiate(run, t, past, y);
    take_residual(past, y);
    matrix_.diagonal() += inverse_step * mass_;
    const auto factors = matrix_.partialPivLu();
    increment = factors.solve(increment_);
    ++run.cost().newton_iterations;
    trial = y + increment;
    f_ = run.rhs(t, trial);
    take_residual(past, trial);
    rest = factors.solve(increment_ - inverse_step * mass_.cwiseProduct(increment));
    const double bend = rest.lpNorm<Eigen::Infinity>() / increment.lpNorm<Eigen::Infinity>();
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
  const auto of = [](double increment, double size) { return increment == 0.0 ? 0.0 : increment / size; };
  const double size = mass_.cwiseProduct(y).lpNorm<Eigen::Infinity>();
  double largest = of(mass_.cwiseProduct(increment_).lpNorm<Eigen::Infinity>(), size);
  for (const auto i : algebraic_) {
    const double weight = matrix_.col(i).lpNorm<Eigen::Infinity>();
    const double relative = of(weight * std::abs(increment_[i]), std::max(size, weight * std::abs(y[i])));
    if (!(relative <= largest)) largest = relative;
  }
  return largest;
}

void NewtonSolver::factorise() {
  matrix_ = *problem_.linear_part;
  assemble();
  factors_.compute(matrix_);
  if (!algebraic_.empty()) singular_ = singular(matrix_);
}

bool NewtonSolver::solve_linear(Run& run, double t, In past, Out y) {
  if (singular_) return false;
  f_ = run.rhs(t, y);
  take_residual(past, y);
  y += factors_.solve(increment_);
  ++run.cost().newton_iterations;
  return y.allFinite();
}

void NewtonSolver::differentiate(Run& run, double t, In past, In y) {
  const Vec sizes = past.cwiseAbs().cwiseMax(kappa_.cwiseProduct(f_).cwiseAbs()).cwiseProduct(mass_);
  fde::differentiate(run, problem_, t, y, f_, sizes, matrix_);
  assemble();
}

void NewtonSolver::assemble() {
  for (const auto i : algebraic_) kappa_[i] = 1.0 / matrix_.row(i).lpNorm<Eigen::Infinity>();
  for (Eigen::Index j = 0; j < matrix_.cols(); ++j) {
    for (Eigen::Index i = 0; i < matrix_.rows(); ++i) matrix_(i, j) *= -kappa_[i];
    matrix_(j, j) += mass_[j];
  }
}

}  // namespace fde
