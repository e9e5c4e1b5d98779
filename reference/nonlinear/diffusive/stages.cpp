// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/diffusive/stages.hpp"

#include <limits>
#include <random>
#include <utility>

#include "fdebench/reference/nonlinear/march/implicit_step.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"

namespace fde::reference {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

Vec largest_of(const Matrix& values) { return values.cwiseAbs().colwise().maxCoeff(); }

double relative_norm(const Matrix& correction, const Vec& sizes) {
  return (largest_of(correction).array() / (sizes.array() + std::numeric_limits<double>::min())).maxCoeff();
}

Matrix weighted(const std::vector<Matrix>& weights, const Matrix& rhs) {
  Matrix sum(rhs.rows(), rhs.cols());
  for (Eigen::Index i = 0; i < rhs.cols(); ++i) {
    sum.col(i) = weights[static_cast<std::size_t>(i)] * rhs.col(i);
  }
  return sum;
}

// The entries with random signs, the same signs in each call.
Matrix with_signs(const Matrix& sizes) {
  std::minstd_rand bits(1);
  return sizes.unaryExpr([&](double size) { return bits() < std::minstd_rand::max() / 2 ? size : -size; });
}

constexpr double known_rounding = 64.0;  // in units of the noise already known
constexpr double noises = 4.0;           // the sum of some rounding errors

}  // namespace

StageEquations::StageEquations(const Problem& problem, Vec nodes)
    : problem_(problem), nodes_(std::move(nodes)), forcing_(largest_forcing(problem)) {}

std::optional<StageSolution> StageEquations::solve(const Matrix& history, const std::vector<Matrix>& weights,
                                                   double from, double length, In last_value, In last_rhs,
                                                   In size) const {
  const Vec times = node_times(problem_, from, length, nodes_);
  double part = first_part(problem_, weights, jacobian_at(problem_, from, last_value));
  if (part == 1.0) {
    const Matrix predicted = history + weighted(weights, last_rhs.transpose().replicate(nodes_.size(), 1));
    return newton(history, weights, times, predicted, size);
  }
  Matrix guess = last_value.transpose().replicate(nodes_.size(), 1);
  if (from > 0.0 && !jumps_at(problem_, from)) part = 1.0;
  for (; part < 1.0; part *= 2.0) {
    auto followed = newton(history, reduced(problem_, weights, part), times, guess, size);
    if (!followed) return followed;
    guess = followed->y;
  }
  return newton(history, weights, times, guess, size);
}

std::optional<StageSolution> StageEquations::newton(const Matrix& history, const std::vector<Matrix>& weights,
                                                    const Vec& times, const Matrix& guess, In size) const {
  constexpr int most_iterations = 40;
  constexpr double nearly_converged = 1e-12;
  StageSolution found{};
  found.y = guess;
  LinearisedStep newton;
  double correction_size = std::numeric_limits<double>::infinity(), last_size = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    found.rhs = rhs_at(problem_, times, found.y);
    Matrix next = history + weighted(weights, found.rhs);
    for (const auto i : algebraic_rows(problem_)) next.col(i) = found.y.col(i);
    if (correction_size < rounding ||
        (correction_size < nearly_converged && correction_size > last_size / 2)) {
      found.y = next;
      return found;
    }
    if (!next.allFinite()) {
      return std::nullopt;
    }
    if (correction_size > last_size / 100) {  // the Jacobian is reused while each iteration gains two digits
      newton = linearise(times, weights, found);
    }
    const Matrix correction = newton.solve(residual_of(problem_, next, found.y, found.rhs));
    if (!correction.allFinite()) {
      return std::nullopt;
    }
    found.y += correction;
    last_size = correction_size;
    correction_size =
        relative_norm(correction, size.cwiseMax(largest_of(found.y)) + found.noise.values / rounding);
  }
  return std::nullopt;
}

LinearisedStep StageEquations::linearise(const Vec& times, const std::vector<Matrix>& weights,
                                         StageSolution& at) const {
  std::vector<Matrix> jacobians;
  for (Eigen::Index k = 0; k < times.size(); ++k) {
    jacobians.push_back(jacobian_at(problem_, times[k], at.y.row(k).transpose()));
  }
  LinearisedStep step(problem_, weights, std::move(jacobians));
  const auto integral = [&](const Matrix& rhs) { return weighted(weights, rhs); };
  const Vec of_times = rounding_of_times(problem_, times[0] / 2.0, times, at.y, at.rhs);
  at.noise = propagated_noise(step, integral, at.y, at.rhs, forcing_ + (rhs_noise_ + of_times) / rounding,
                              with_signs);
  return step;
}

Vec StageNoise::above_noise(const Vec& coefficients, const Vec& noise) {
  return coefficients - noises * noise;
}

bool StageNoise::detect(const StageSolution& stages, double from, double length, const Vec& tolerated,
                        double scale) {
  const Vec unresolved = (rule_.at_nodes.bottomRows(2) * stages.rhs).cwiseAbs().colwise().maxCoeff();
  const Vec negligible = known_rounding * stages.noise.rhs + tolerated;
  return rhs_noise_.detect(from + length * rule_.nodes.cast<double>().array(), stages.y, unresolved,
                           negligible, scale);
}

bool StageNoise::detect_on_last_step(const Vec& size) {
  if (!last_) {
    return false;
  }
  const Vec rhs_size = last_->stages.rhs.cwiseAbs().colwise().maxCoeff();
  const Vec negligible = known_rounding * last_->stages.noise.rhs;
  const Vec unresolved = negligible.cwiseMax(std::numeric_limits<double>::min());
  return rhs_noise_.detect(times(*last_), last_->stages.y, unresolved, negligible,
                           size.cwiseMax(rhs_size).maxCoeff());
}

void StageNoise::record_accepted_step(const StageSolution& stages, double length, double to) {
  last_ = {stages, length, to};
  const Vec explained = noises * (stages.noise.rhs - rhs_noise_.allowance());
  rhs_noise_.update_after_step(times(*last_), stages.y, explained);
}

// Computed from the end of the step, where the next step starts.
Vec StageNoise::times(const Step& step) const {
  return step.to + step.length * (rule_.nodes.cast<double>().array() - 1.0);
}

}  // namespace fde::reference
