// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/panel_equations.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "fdebench/reference/nonlinear/march/implicit_step.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"

namespace fde::reference {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

// The largest correction relative to the size of its component; a component of size 0 must not change.
double relative_norm(const Matrix& correction, const Vec& sizes) {
  const Vec largest = correction.cwiseAbs().colwise().maxCoeff();
  return (largest.array() / (sizes.array() + std::numeric_limits<double>::min())).maxCoeff();
}

Matrix with_signs(const Matrix& sizes) {
  std::minstd_rand generator(3);
  return sizes.unaryExpr([&](double size) { return generator() % 2 == 0 ? size : -size; });
}

constexpr double some_roundings = roundings_of_forcing * rounding;
constexpr double noises = 4.0;  // the sum of some rounding errors

}  // namespace

PanelEquations::PanelEquations(const Problem& problem, const PanelBasis& basis)
    : problem_(problem), basis_(basis) {
  for (const Component& component : problem.components) {
    integral_.push_back(is_algebraic(component) ? basis.at_targets : basis.integral(component.order));
  }
}

std::optional<PanelEquations::Solution> PanelEquations::solve(const Matrix& history, double from, double to,
                                                              In first_rhs,
                                                              const MagnitudeScales& before) const {
  const double length = to - from;
  const Vec times = node_times(problem_, from, length, basis_.nodes);
  Matrix guess = history + integrate(first_rhs.transpose().replicate(basis_.points(), 1), length);
  double part = 1.0;
  if (from == 0.0 || jumps_at(problem_, from)) {
    part = first_part(problem_, weights(length), jacobian_at(problem_, times[0], history.row(0).transpose()));
    if (part < 1.0) guess = history;
  }
  for (; part < 1.0; part *= 2.0) {
    auto followed = newton({history, times, from, length, part}, guess, before);
    if (!followed) return followed;
    guess = followed->values;
  }
  return newton({history, times, from, length, 1.0}, guess, before);
}

std::optional<PanelEquations::Solution> PanelEquations::newton(const Step& step, const Matrix& guess,
                                                               const MagnitudeScales& before) const {
  constexpr int most_iterations = 40;
  constexpr double nearly_converged = 1e-12;
  const Eigen::Index points = basis_.points();
  Solution found{};
  found.values = guess;
  LinearisedStep newton;
  double size = std::numeric_limits<double>::infinity(), last_size = 0.0;  // of the corrections
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    found.rhs = rhs_at(problem_, step.times, found.values);
    const Matrix next = right_hand_side(step, found);
    if (size < 2 * rounding || (size < nearly_converged && size > last_size / 2)) {
      found.values = next;
      return found;
    }
    if (!next.allFinite()) {
      return std::nullopt;
    }
    if (size > last_size / 10) {  // the Jacobian is reused while each iteration gains a digit
      newton = linearise(step, before, found);
    }
    const Matrix correction =
        newton.solve(residual_of(problem_, next.topRows(points), found.values.topRows(points), found.rhs));
    if (!correction.allFinite()) {
      return std::nullopt;
    }
    found.values.topRows(points) += correction;
    last_size = size;
    size = relative_norm(correction, found.sizes.values + found.increment + found.noise.values / rounding);
  }
  return std::nullopt;
}

LinearisedStep PanelEquations::linearise(const Step& step, const MagnitudeScales& before,
                                         Solution& at) const {
  const Matrix y = at.values.topRows(step.times.size());
  std::vector<Matrix> jacobians;
  for (Eigen::Index k = 0; k < step.times.size(); ++k) {
    jacobians.push_back(jacobian_at(problem_, step.times[k], y.row(k).transpose()));
  }
  at.sizes = updated_scales(without_unbounded_scales(before, problem_), y, at.rhs, jacobians);
  at.increment = unit_increment(problem_, step.length).cwiseProduct(at.sizes.rhs.cwiseMax(at.sizes.forcing));
  LinearisedStep linear(problem_, reduced(problem_, weights(step.length), step.part), std::move(jacobians));
  const auto integral = [&](const Matrix& rhs) -> Matrix {
    return integrate(rhs, step.length).topRows(rhs.rows());
  };
  const Vec further =
      at.sizes.forcing +
      (at.sizes.noise + rounding_of_times(problem_, step.from, step.times, y, at.rhs)) / rounding;
  at.noise = propagated_noise(linear, integral, y, at.rhs, further, with_signs);
  at.left_unresolved =
      propagated_noise(linear, integral, y, at.rhs, roundings_of_forcing * at.sizes.forcing, with_signs);
  return linear;
}

// The unknowns of algebraic rows are kept, and extrapolated to the end of the panel.
Matrix PanelEquations::right_hand_side(const Step& step, const Solution& from) const {
  Matrix next = step.history + step.part * integrate(from.rhs, step.length);
  for (const auto i : algebraic_rows(problem_))
    next.col(i) = basis_.at_targets * from.values.col(i).head(basis_.points());
  return next;
}

Matrix PanelEquations::integrate(const Matrix& rhs, double length) const {
  Matrix sum(basis_.targets.size(), problem_.size());
  for (Eigen::Index i = 0; i < problem_.size(); ++i) {
    const auto component = static_cast<std::size_t>(i);
    sum.col(i) = std::pow(length, problem_.components[component].order) * (integral_[component] * rhs.col(i));
  }
  return sum;
}

std::vector<Matrix> PanelEquations::weights(double length) const {
  std::vector<Matrix> weights;
  for (std::size_t i = 0; i < integral_.size(); ++i) {
    weights.emplace_back(std::pow(length, problem_.components[i].order) *
                         integral_[i].topRows(basis_.points()));
  }
  return weights;
}

MagnitudeScales without_unbounded_scales(MagnitudeScales sizes, const Problem& problem) {
  if (!has_algebraic_rows(problem)) return sizes;
  sizes.rhs.setZero();
  sizes.values(algebraic_rows(problem)).setZero();
  return sizes;
}

MagnitudeScales sizes_at_start(const Problem& problem) {
  const Vec initial = taylor_part(problem, 0.0);
  return {initial.cwiseAbs(), rhs_at(problem, 0.0, initial).cwiseAbs(), largest_forcing(problem),
          Vec::Zero(problem.size())};
}

MagnitudeScales updated_scales(const MagnitudeScales& before, const Matrix& y, const Matrix& rhs,
                               const std::vector<Matrix>& jacobians) {
  MagnitudeScales sizes = before;
  for (Eigen::Index k = 0; k < rhs.rows(); ++k) {
    const Vec y_size = y.row(k).transpose().cwiseAbs();
    const Vec terms = jacobians[static_cast<std::size_t>(k)].cwiseAbs() * y_size;
    sizes.values = sizes.values.cwiseMax(y_size);
    sizes.rhs = sizes.rhs.cwiseMax(terms).cwiseMax(rhs.row(k).transpose().cwiseAbs());
  }
  return sizes;
}

PanelNoise::PanelNoise(const Problem& problem, const PanelBasis& basis, double tolerance)
    : problem_(problem), basis_(basis), tolerance_(tolerance), rhs_noise_(problem) {}

Vec PanelNoise::negligible_rhs(const Solution& panel) const {
  return tolerance_ * panel.sizes.rhs + some_roundings * panel.sizes.forcing + noises * panel.noise.rhs +
         panel.left_unresolved.rhs;
}

Vec PanelNoise::negligible_values(const Solution& panel) const {
  return tolerance_ * panel.sizes.values + some_roundings * panel.increment + noises * panel.noise.values +
         panel.left_unresolved.values;
}

bool PanelNoise::detect(const Solution& panel, double from, double to, double scale) {
  constexpr Eigen::Index tail = 4;
  const Matrix coefficients = basis_.legendre * panel.rhs;
  const Vec unresolved = coefficients.bottomRows(tail).cwiseAbs().colwise().maxCoeff();
  return rhs_noise_.detect(from + (to - from) * basis_.nodes.array(), panel.values.topRows(basis_.points()),
                           unresolved, negligible_rhs(panel), scale);
}

bool PanelNoise::detect(const Panel& last, const MagnitudeScales& sizes) {
  const Vec negligible = some_roundings * (sizes.rhs + sizes.forcing);
  const Vec unresolved = negligible.cwiseMax(std::numeric_limits<double>::min());
  return rhs_noise_.detect(last.from + last.length() * basis_.dense_nodes.array(), last.values, unresolved,
                           negligible, sizes.largest());
}

Vec PanelNoise::record_panel(const Solution& panel, double from, double to, const Matrix& values) {
  panels_.push_back({from, to, panel.sizes.noise, panel.noise.values});
  const Vec explained = noises * rounding * (panel.sizes.rhs + panel.sizes.forcing);
  rhs_noise_.update_after_step(from + (to - from) * basis_.dense_nodes.array(), values, explained);
  return panel.sizes.values + panel.increment + (largest_of_values(to) + integrated(to)) / rounding;
}

// The noise of y on the panels since a tenth of the time. Multipliers, and what they drive, have noise on the
// first panels that grows as these get shorter; later their integrals remain, which are noise of the present
// size.
Vec PanelNoise::largest_of_values(double to) const {
  constexpr double window = 10.0;
  Vec largest = panels_.back().values_noise;
  for (std::size_t k = panels_.size(); k-- > 0 && window * panels_[k].to >= to;)
    largest = largest.cwiseMax(panels_[k].values_noise);
  return largest;
}

// An upper bound of the contribution of the noise of f to y, as if the noise had the same sign throughout.
Vec PanelNoise::integrated(double to) const {
  const auto added_since = [&](double time, const Vec& rhs_noise) -> Vec {
    return unit_increment(problem_, to - time).cwiseProduct(rhs_noise);
  };
  Vec sum = added_since(panels_.back().from, panels_.back().rhs_noise);
  for (std::size_t k = 0; k + 1 < panels_.size(); ++k) {
    const auto& [start, end, noise, of_values] = panels_[k];
    if (!noise.isZero(0.0)) {
      sum += (added_since(start, noise) - added_since(end, noise)).cwiseMax(0.0);
    }
  }
  return sum;
}

}  // namespace fde::reference
