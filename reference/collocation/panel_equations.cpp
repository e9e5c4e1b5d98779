#include "collocation/panel_equations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace fde {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

// The largest correction relative to the size of its component; a component of size 0 has to stay put.
double relative_size(const Matrix& correction, const Vec& sizes) {
  const Vec largest = correction.cwiseAbs().colwise().maxCoeff();
  return (largest.array() / (sizes.array() + std::numeric_limits<double>::min())).maxCoeff();
}

// Rounding errors as large as they can be, of random signs that are the same each time.
Matrix rounding_errors(const Matrix& sizes) {
  std::minstd_rand generator(3);
  return sizes.unaryExpr(
      [&](double size) { return generator() % 2 == 0 ? rounding * size : -rounding * size; });
}

Sizes sizes_with(const Sizes& before, const Matrix& y, const Matrix& rhs,
                 const std::vector<Matrix>& jacobians) {
  Sizes sizes = before;
  for (Eigen::Index k = 0; k < rhs.rows(); ++k) {
    const Vec y_size = y.row(k).transpose().cwiseAbs();
    const Vec terms = jacobians[static_cast<std::size_t>(k)].cwiseAbs() * y_size;
    sizes.values = sizes.values.cwiseMax(y_size);
    sizes.rhs = sizes.rhs.cwiseMax(terms).cwiseMax(rhs.row(k).transpose().cwiseAbs());
  }
  return sizes;
}

}  // namespace

Vec increment_of(const Problem& problem, const Vec& rhs_size, double length) {
  Vec size(problem.size());
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.components[static_cast<std::size_t>(i)].order;
    size[i] = std::pow(length, order) / std::tgamma(order + 1.0) * rhs_size[i];
  }
  return size;
}

PanelEquations::PanelEquations(const Problem& problem, const PanelBasis& basis)
    : problem_(problem), basis_(basis) {
  for (const Component& component : problem.components) {
    integral_.push_back(basis.integral(component.order));
  }
}

std::optional<PanelEquations::Solution> PanelEquations::solve(const Matrix& past, double from, double to,
                                                              In first_rhs, const Sizes& before) const {
  constexpr int most_iterations = 40;
  constexpr double nearly_converged = 1e-12;
  const Eigen::Index points = basis_.points();
  const double length = to - from;
  const Vec times = from + length * basis_.nodes.array();
  Matrix y = past + integrate(first_rhs.transpose().replicate(points, 1), length);
  Eigen::PartialPivLU<Matrix> newton;
  Sizes sizes = before;
  Vec increments;
  Noise rounded;
  double size = std::numeric_limits<double>::infinity();
  double last_size = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Matrix rhs = rhs_at(times, y);
    const Matrix next = past + integrate(rhs, length);
    const bool converged = size < 2 * rounding || (size < nearly_converged && size > last_size / 2);
    if (converged) {
      return Solution{next, rhs, sizes, increments, rounded};
    }
    if (!next.allFinite()) {
      return std::nullopt;
    }
    if (size > last_size / 10) {  // an old factorisation serves while it gains a digit each time
      std::vector<Matrix> jacobians;
      for (Eigen::Index k = 0; k < points; ++k) {
        jacobians.push_back(jacobian_at(times[k], y.row(k).transpose()));
      }
      newton.compute(newton_matrix(jacobians, length));
      sizes = sizes_with(before, y, rhs, jacobians);
      increments = increment_of(problem_, sizes.rhs.cwiseMax(sizes.forcing), length);
      rounded = noise(newton, jacobians, y.topRows(points), rhs, sizes.noise, length);
    }
    const Matrix residual = (next - y).topRows(points);
    const Matrix correction = newton.solve(residual.reshaped()).reshaped(points, problem_.size());
    if (!correction.allFinite()) {
      return std::nullopt;
    }
    y.topRows(points) += correction;
    last_size = size;
    size = relative_size(correction, sizes.values + increments + rounded.values / rounding);
  }
  return std::nullopt;
}

Matrix PanelEquations::rhs_at(const Vec& times, const Matrix& y) const {
  Matrix rhs(times.size(), problem_.size());
  Vec f(problem_.size());
  for (Eigen::Index k = 0; k < times.size(); ++k) {
    problem_.rhs(times[k], y.row(k).transpose(), f);
    rhs.row(k) = f;
  }
  return rhs;
}

Matrix PanelEquations::jacobian_at(double t, In y) const {
  Matrix jacobian(y.size(), y.size());
  if (evaluate_jacobian(problem_, t, y, jacobian)) {
    return jacobian;
  }
  Vec moved = y, f(y.size()), f_moved(y.size());
  problem_.rhs(t, y, f);
  for (Eigen::Index l = 0; l < y.size(); ++l) {
    moved[l] = y[l] + std::sqrt(rounding) * std::max(1.0, std::abs(y[l]));
    problem_.rhs(t, moved, f_moved);
    jacobian.col(l) = (f_moved - f) / (moved[l] - y[l]);
    moved[l] = y[l];
  }
  return jacobian;
}

Matrix PanelEquations::integrate(const Matrix& rhs, double length) const {
  Matrix sum(basis_.targets.size(), problem_.size());
  for (Eigen::Index i = 0; i < problem_.size(); ++i) {
    const auto component = static_cast<std::size_t>(i);
    sum.col(i) = std::pow(length, problem_.components[component].order) * (integral_[component] * rhs.col(i));
  }
  return sum;
}

// d(y - past - integral)/dy, unknowns numbered component by component.
Matrix PanelEquations::newton_matrix(const std::vector<Matrix>& jacobians, double length) const {
  const Eigen::Index points = basis_.points(), size = problem_.size();
  Matrix matrix = Matrix::Identity(points * size, points * size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto component = static_cast<std::size_t>(i);
    const Matrix weights =
        std::pow(length, problem_.components[component].order) * integral_[component].topRows(points);
    for (Eigen::Index l = 0; l < size; ++l) {
      for (Eigen::Index j = 0; j < points; ++j) {
        matrix.block(i * points, l * points + j, points, 1) -=
            jacobians[static_cast<std::size_t>(j)](i, l) * weights.col(j);
      }
    }
  }
  return matrix;
}

// What Newton's matrix makes of an error in the last digit of y and of each term of f at every node. Larger
// than the last digit of y_i where y_i is small and driven, through other components, by f of large terms.
PanelEquations::Noise PanelEquations::noise(const Eigen::PartialPivLU<Matrix>& newton,
                                            const std::vector<Matrix>& jacobians, const Matrix& y,
                                            const Matrix& rhs, const Vec& rhs_noise, double length) const {
  const Matrix y_size = y.cwiseAbs();
  const auto passed_on = [&](const Matrix& of_y) {
    Matrix of_rhs(rhs.rows(), rhs.cols());
    for (Eigen::Index k = 0; k < rhs.rows(); ++k) {
      of_rhs.row(k) = of_y.row(k) * jacobians[static_cast<std::size_t>(k)].cwiseAbs().transpose();
    }
    return of_rhs;
  };
  const Matrix rhs_size = (rhs.cwiseAbs() + passed_on(y_size)).rowwise() + rhs_noise.transpose() / rounding;
  const Matrix of_rhs = rounding_errors(rhs_size);
  const Matrix residual = rounding_errors(y_size) + integrate(of_rhs, length).topRows(y.rows());
  const Matrix of_y = newton.solve(residual.reshaped()).reshaped(y.rows(), y.cols()).cwiseAbs();
  return {of_y.colwise().maxCoeff(), (of_rhs.cwiseAbs() + passed_on(of_y)).colwise().maxCoeff()};
}

}  // namespace fde
