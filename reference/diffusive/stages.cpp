#include "diffusive/stages.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace fde {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

Matrix weighted(const std::vector<Matrix>& weights, const Matrix& rhs) {
  Matrix sum(rhs.rows(), rhs.cols());
  for (Eigen::Index i = 0; i < rhs.cols(); ++i) {
    sum.col(i) = weights[static_cast<std::size_t>(i)] * rhs.col(i);
  }
  return sum;
}

// 1 - weights_i (d f_i / d y_l), unknowns numbered component by component.
Matrix newton_matrix(const std::vector<Matrix>& weights, const std::vector<Matrix>& jacobians) {
  const auto stages = std::ssize(jacobians), size = std::ssize(weights);
  Matrix matrix = Matrix::Identity(stages * size, stages * size);
  for (Eigen::Index k = 0; k < stages; ++k) {
    const Matrix& jacobian = jacobians[static_cast<std::size_t>(k)];
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index l = 0; l < size; ++l) {
        if (jacobian(i, l) != 0.0) {
          matrix.block(i * stages, l * stages + k, stages, 1) -=
              jacobian(i, l) * weights[static_cast<std::size_t>(i)].col(k);
        }
      }
    }
  }
  return matrix;
}

// The numbers of a matrix with random signs, always the same ones.
Matrix with_signs(const Matrix& sizes) {
  std::minstd_rand bits(1);
  return sizes.unaryExpr([&](double size) { return bits() < std::minstd_rand::max() / 2 ? size : -size; });
}

// Rounding as it arrives in y: each f_i is off by its last digit, and by that of the terms that it is made
// of, and each y_i by its own. Newton's matrix passes it on from component to component.
void find_noise(const Eigen::PartialPivLU<Matrix>& newton, const std::vector<Matrix>& weights,
                const std::vector<Matrix>& jacobians, In forcing, In noise_of_rhs, StageSolution& solution) {
  Matrix rhs_size = solution.rhs.cwiseAbs().rowwise() + (forcing + noise_of_rhs / rounding).transpose();
  const Matrix y_size = solution.y.cwiseAbs();
  for (Eigen::Index k = 0; k < y_size.rows(); ++k) {
    rhs_size.row(k) += y_size.row(k) * jacobians[static_cast<std::size_t>(k)].cwiseAbs().transpose();
  }
  const Matrix of_rhs = with_signs(rounding * rhs_size);
  const Matrix residual = with_signs(rounding * y_size) + weighted(weights, of_rhs);
  const Matrix noise = newton.solve(residual.reshaped()).reshaped(y_size.rows(), y_size.cols()).cwiseAbs();
  Matrix rhs_noise = of_rhs.cwiseAbs();
  for (Eigen::Index k = 0; k < y_size.rows(); ++k) {
    rhs_noise.row(k) += noise.row(k) * jacobians[static_cast<std::size_t>(k)].cwiseAbs().transpose();
  }
  solution.y_noise = noise.colwise().maxCoeff();
  solution.rhs_noise = rhs_noise.colwise().maxCoeff();
}

Vec largest_forcing(const Problem& problem) {
  constexpr int samples = 50;
  const Vec initial = taylor_part(problem, 0.0);
  Vec largest = Vec::Zero(problem.size()), f(problem.size());
  for (int k = 0; k <= samples; ++k) {
    problem.rhs(problem.end * k / samples, initial, f);
    largest = largest.cwiseMax(f.allFinite() ? Vec(f.cwiseAbs()) : largest);
  }
  return largest;
}

}  // namespace

StageEquations::StageEquations(const Problem& problem, Vec nodes)
    : problem_(problem), nodes_(std::move(nodes)), forcing_(largest_forcing(problem)) {}

std::optional<StageSolution> StageEquations::solve(const Matrix& past, const std::vector<Matrix>& weights,
                                                   double from, double length, In first_rhs, In size) const {
  constexpr int most_iterations = 40;
  constexpr double nearly_converged = 1e-12;
  const Vec times = from + length * nodes_.array();
  StageSolution solution;
  solution.y = past + weighted(weights, first_rhs.transpose().replicate(nodes_.size(), 1));
  Eigen::PartialPivLU<Matrix> newton;
  double correction_size = std::numeric_limits<double>::infinity(), last_size = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    solution.rhs = rhs_at(times, solution.y);
    const Matrix next = past + weighted(weights, solution.rhs);
    if (correction_size < rounding ||
        (correction_size < nearly_converged && correction_size > last_size / 2)) {
      solution.y = next;
      return solution;
    }
    if (!next.allFinite()) {
      return std::nullopt;
    }
    if (correction_size >
        last_size / 100) {  // an old factorisation serves while it gains two digits each time
      const auto jacobians = jacobians_at(times, solution.y);
      newton.compute(newton_matrix(weights, jacobians));
      find_noise(newton, weights, jacobians, forcing_, rhs_noise_, solution);
    }
    const Matrix correction = newton.solve((next - solution.y).reshaped()).reshaped(past.rows(), past.cols());
    if (!correction.allFinite()) {
      return std::nullopt;
    }
    solution.y += correction;
    const Vec largest = correction.cwiseAbs().colwise().maxCoeff();
    const Vec sizes =
        size.cwiseMax(solution.y.cwiseAbs().colwise().maxCoeff().transpose()) + solution.y_noise / rounding;
    last_size = correction_size;
    correction_size = (largest.array() / (sizes.array() + std::numeric_limits<double>::min())).maxCoeff();
  }
  return std::nullopt;
}

Matrix StageEquations::rhs_at(const Vec& times, const Matrix& y) const {
  Matrix rhs(y.rows(), y.cols());
  Vec f(y.cols());
  for (Eigen::Index k = 0; k < y.rows(); ++k) {
    problem_.rhs(times[k], y.row(k).transpose(), f);
    rhs.row(k) = f.transpose();
  }
  return rhs;
}

std::vector<Matrix> StageEquations::jacobians_at(const Vec& times, const Matrix& y) const {
  std::vector<Matrix> jacobians;
  for (Eigen::Index k = 0; k < y.rows(); ++k) {
    jacobians.push_back(jacobian_at(times[k], y.row(k).transpose()));
  }
  return jacobians;
}

Matrix StageEquations::jacobian_at(double t, const Vec& y) const {
  Matrix jacobian(y.size(), y.size());
  if (evaluate_jacobian(problem_, t, y, jacobian)) {
    return jacobian;
  }
  Vec moved = y, above(y.size()), below(y.size());
  for (Eigen::Index l = 0; l < y.size(); ++l) {
    const double shift = std::cbrt(rounding) * std::max(1.0, std::abs(y[l]));
    moved[l] = y[l] + shift;
    problem_.rhs(t, moved, above);
    moved[l] = y[l] - shift;
    problem_.rhs(t, moved, below);
    moved[l] = y[l];
    jacobian.col(l) = (above - below) / (2 * shift);
  }
  return jacobian;
}

}  // namespace fde
