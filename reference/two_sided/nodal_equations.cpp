// SPDX-License-Identifier: MIT
#include "fdebench/reference/two_sided/nodal_equations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fdebench/reference/nonlinear/march/implicit_step.hpp"
#include "fdebench/schemes/problem/initial_guess.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

constexpr std::size_t most_iterations = 60;
constexpr int most_halvings = 20;
constexpr double rounding = 1e-13, small = 1e-9;

// Damped Newton step: adds the increment, or the largest of its half, quarter, ... that decreases the
// residual. Returns the size of the full increment, since damped iterations have not converged. Small
// increments are always added in full: their effect on the residual is rounding.
double damped_newton_step(const NodalEquations& equations, NodalValues& values) {
  const NodalResidual residual = equations.residual(values);
  const NodalValues increment = equations.increment(values, residual);
  const double size = increment.size();
  const bool last = size <= small * std::max(1.0, values.size());
  double part = 1.0;
  for (int halving = 0; halving < most_halvings; ++halving, part /= 2) {
    NodalValues trial{values.y + part * increment.y, values.unknown + part * increment.unknown};
    const double after = equations.residual(trial).norm();
    if (!(after < residual.norm() || (last && std::isfinite(after)))) continue;
    values = std::move(trial);
    return size;
  }
  throw std::runtime_error("two-sided reference: Newton's method finds no way down");
}

NodalValues first_iterate(const NodalEquations& equations, const NodalBasis& basis,
                          const std::function<Vec(RelativeTime t)>& start) {
  NodalValues values = equations.start();
  if (!start) return values;
  for (std::size_t m = 0; m < basis.nodes.size(); ++m)
    values.y.row(static_cast<Eigen::Index>(m)) = start(basis.nodes[m]).transpose();
  return values;
}

NodalValues solved(const NodalEquations& equations, NodalValues values) {
  double before = std::numeric_limits<double>::infinity();
  for (std::size_t iteration = 0; iteration < most_iterations; ++iteration) {
    report_progress(iteration);
    const double moved = damped_newton_step(equations, values), size = std::max(1.0, values.size());
    if (moved <= rounding * size || (moved >= before / 2 && moved <= 1e3 * rounding * size)) return values;
    before = moved;
  }
  throw std::runtime_error("two-sided reference: Newton's method does not converge");
}

}  // namespace

double NodalValues::size() const {
  const double of_y = y.cwiseAbs().maxCoeff();
  return unknown.size() > 0 ? std::max(of_y, unknown.cwiseAbs().maxCoeff()) : of_y;
}

double NodalResidual::norm() const {
  return std::sqrt(rows.squaredNorm() / static_cast<double>(rows.rows()) + conditions.squaredNorm());
}

NodalEquations::NodalEquations(const Problem& problem, const NodalBasis& basis)
    : problem_(problem), basis_(basis) {
  std::map<KernelKey, Matrix> at_nodes;
  if (has_algebraic_rows(problem))
    throw std::invalid_argument("a two-sided reference takes no algebraic rows");
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& [order, initial, side] = problem_.component(i);
    for (std::size_t k = initial.size(); k < initial_count(order); ++k)
      unknown_.push_back({i, static_cast<int>(k)});
    auto& weights = at_nodes[{order, side}];
    if (weights.size() == 0) {
      const auto row = [left = side == Side::left, weights_of = basis.rows(order),
                        scale = std::pow(problem.end, order)](RelativeTime t) -> Vec {
        if (left) return scale * weights_of(t);
        return scale * weights_of(t.reversed()).reverse();
      };
      weights.resize(nodes(), nodes());
      for (Eigen::Index m = 0; m < nodes(); ++m) weights.row(m) = row(node(m)).transpose();
      rows_[{order, side}] = row;
    }
    weights_.push_back(weights);
  }
}

double NodalEquations::time_from_side(Eigen::Index i, RelativeTime t) const {
  return problem_.end * (problem_.component(i).side == Side::left ? t.from_start : t.from_end);
}

double NodalEquations::time(RelativeTime t) const {
  return t.from_start < 0.5 ? problem_.end * t.from_start : problem_.end - problem_.end * t.from_end;
}

Vec NodalEquations::taylor_part_at(RelativeTime t, In unknown) const {
  Vec part = Vec::Zero(problem_.size());
  for (Eigen::Index i = 0; i < part.size(); ++i) {
    double term = 1.0, power = 0.0;
    for (const double value : problem_.component(i).initial) {
      part[i] += value * term;
      term *= time_from_side(i, t) / ++power;
    }
  }
  Eigen::Index next = 0;
  for (const auto& [i, power] : unknown_)
    part[i] += unknown[next++] * std::pow(time_from_side(i, t), power) / std::tgamma(power + 1.0);
  return part;
}

Matrix NodalEquations::taylor_part_at_nodes(In unknown) const {
  Matrix part(nodes(), problem_.size());
  for (Eigen::Index m = 0; m < nodes(); ++m) part.row(m) = taylor_part_at(node(m), unknown).transpose();
  return part;
}

NodalValues NodalEquations::start() const {
  const Vec none = Vec::Zero(std::ssize(unknown_));
  return {taylor_part_at_nodes(none), none};
}

Matrix NodalEquations::rhs(const Matrix& y) const {
  Matrix f(nodes(), problem_.size());
  Vec value(problem_.size());
  for (Eigen::Index m = 0; m < nodes(); ++m) {
    problem_.rhs(time(node(m)), y.row(m).transpose(), value);
    f.row(m) = value.transpose();
  }
  return f;
}

NodalResidual NodalEquations::residual(const NodalValues& values) const {
  NodalResidual result{taylor_part_at_nodes(values.unknown) - values.y, conditions(values.y)};
  const Matrix f = rhs(values.y);
  for (Eigen::Index i = 0; i < problem_.size(); ++i)
    result.rows.col(i) += weights_[static_cast<std::size_t>(i)] * f.col(i);
  return result;
}

Vec NodalEquations::conditions(const Matrix& y) const {
  Vec result(std::ssize(unknown_));
  if (!unknown_.empty()) problem_.conditions(y.row(0).transpose(), y.row(nodes() - 1).transpose(), result);
  return result;
}

// The derivative of the conditions in the direction `change`, by central differences.
Vec NodalEquations::conditions_along(const Matrix& y, const Matrix& change) const {
  const double size = std::max(1.0, y.cwiseAbs().maxCoeff());
  const double part = 0x1p-20 * size / std::max(1e-300, change.cwiseAbs().maxCoeff());
  return (conditions(y + part * change) - conditions(y - part * change)) / (2.0 * part);
}

// Block elimination: the rows are solved for the residual and for a unit change of each unknown initial
// value; the conditions then determine the unknown initial values.
NodalValues NodalEquations::increment(const NodalValues& values, const NodalResidual& residual) const {
  std::vector<Matrix> jacobians;
  for (Eigen::Index m = 0; m < nodes(); ++m)
    jacobians.push_back(jacobian_at(problem_, time(node(m)), values.y.row(m).transpose()));
  const LinearisedStep step(problem_, weights_, std::move(jacobians));
  const auto count = std::ssize(unknown_);
  NodalValues increment{step.solve(residual.rows), Vec::Zero(count)};
  if (count == 0) return increment;
  const Matrix known = taylor_part_at_nodes(Vec::Zero(count));
  std::vector<Matrix> answers;
  Matrix sensitivities(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    answers.push_back(step.solve(taylor_part_at_nodes(Vec::Unit(count, k)) - known));
    sensitivities.col(k) = conditions_along(values.y, answers.back());
  }
  const Vec missing = residual.conditions + conditions_along(values.y, increment.y);
  increment.unknown = -sensitivities.partialPivLu().solve(missing);
  for (Eigen::Index k = 0; k < count; ++k)
    increment.y += increment.unknown[k] * answers[static_cast<std::size_t>(k)];
  return increment;
}

Vec NodalEquations::at(RelativeTime t, const Matrix& f, In unknown) const {
  std::map<KernelKey, Vec> weights;
  for (const auto& [kind, row] : rows_) weights[kind] = row(t);
  Vec y = taylor_part_at(t, unknown);
  for (Eigen::Index i = 0; i < y.size(); ++i)
    y[i] += weights.at({problem_.component(i).order, problem_.component(i).side}).dot(f.col(i));
  return y;
}

NodalSolution::NodalSolution(const Problem& problem, const NodalBasis& basis,
                             const std::function<Vec(RelativeTime t)>& start)
    : equations_(problem, basis),
      values_(solved(equations_, first_iterate(equations_, basis, start))),
      f_(equations_.rhs(values_.y)) {}

NodalSolution smallest_solution(const Problem& problem, const NodalBasis& basis) {
  constexpr int starts = 64, times = 64;
  std::optional<NodalSolution> smallest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& start : initial_guesses(problem, starts)) {
    try {
      NodalSolution found(problem, basis,
                          [&](RelativeTime t) { return start.at(problem.end * t.from_start); });
      double size = 0.0;
      for (int n = 0; n <= times; ++n) {
        const double share = static_cast<double>(n) / times;
        size += found.at({share, 1.0 - share}).squaredNorm();
      }
      if (!(size < least)) continue;
      least = size;
      smallest.emplace(std::move(found));
    } catch (const std::runtime_error&) {
      continue;  // no convergence from these initial values
    }
  }
  if (!smallest) throw std::runtime_error("two-sided reference: no start of Newton's method converges");
  return std::move(*smallest);
}

}  // namespace fde::reference
