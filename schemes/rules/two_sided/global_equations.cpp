// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/global_equations.hpp"

#include <cmath>

namespace fde {

double Residual::norm() const {
  return std::sqrt(rows.squaredNorm() / static_cast<double>(rows.cols()) + conditions.squaredNorm());
}

GlobalEquations::GlobalEquations(const Problem& problem, const Grid& grid, const Options& options,
                                 const WeightFamily& family)
    : problem_(problem),
      options_(options),
      family_(family),
      grid_(grid),
      left_(problem, Side::left, family, grid, options),
      right_(problem, Side::right, family, grid, options),
      unknown_(problem) {}

GlobalEquations GlobalEquations::with_steps(int steps) const {
  return {problem_, {grid_.end, steps, grid_.grading}, options_, family_};
}

GridFunction GlobalEquations::initial_guess() const {
  GridFunction guess{.y = Rows(problem_.size(), grid_.steps + 1), .unknown = Vec::Zero(unknown_.count())};
  const TaylorPart taylor(problem_);
  Vec value(problem_.size());
  for (const auto* side : {&left_, &right_}) {
    for (Eigen::Index m = 0; m < guess.y.cols(); ++m) {
      taylor.at(side->time_from_side(m), value);
      for (const auto i : side->rows()) guess.y(i, side->grid_index(m)) = value[i];
    }
  }
  return guess;
}

Residual GlobalEquations::residual(Run& run, const GridFunction& guess) const {
  Residual result{.rows = initial_guess().y, .conditions = Vec(unknown_.count()), .f = Rows(guess.y)};
  for (Eigen::Index n = 0; n < guess.y.cols(); ++n)
    result.f.col(n) = run.rhs(grid_.time(static_cast<int>(n)), guess.y.col(n));
  add_unknown(guess.unknown, result.rows);
  result.rows -= guess.y;
  left_.integrate(result.f, result.rows);
  right_.integrate(result.f, result.rows);
  if (problem_.conditions)
    problem_.conditions(guess.y.leftCols<1>().col(0), guess.y.rightCols<1>().col(0), result.conditions);
  return result;
}

void GlobalEquations::add_unknown(In unknown, Rows& y) const {
  if (unknown_.count() == 0) return;
  for (int n = 0; n <= grid_.steps; ++n)
    unknown_.add(unknown, grid_.time(n), grid_.time(grid_.steps - n), y.col(n));
}

UnknownInitialValues::UnknownInitialValues(const Problem& problem) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& component = problem.components[static_cast<std::size_t>(i)];
    const auto needed = initial_count(component.order);
    for (std::size_t k = component.initial.size(); k < needed; ++k)
      unknowns_.push_back({i, component.side, k, is_algebraic(component)});
  }
}

void UnknownInitialValues::add(In values, double left, double right, Out y) const {
  Eigen::Index next = 0;
  for (const auto& [component, side, power, algebraic] : unknowns_) {
    const double time = side == Side::left ? left : right;
    double term = values[next++];
    for (std::size_t k = 1; k <= power; ++k) term *= time / static_cast<double>(k);
    if (!algebraic || time == 0.0) y[component] += term;
  }
}

}  // namespace fde
