// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/global_equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fdebench/schemes/rules/implicit/difference_jacobian.hpp"

namespace fde {

double Residual::norm() const {
  return std::sqrt(rows.squaredNorm() / static_cast<double>(rows.cols()) + conditions.squaredNorm());
}

GlobalEquations::GlobalEquations(const Problem& problem, std::shared_ptr<const Discretisation> discretisation)
    : problem_(problem), discretisation_(std::move(discretisation)), taylor_(problem), unknown_(problem) {}

GlobalEquations GlobalEquations::with_steps(int steps) const {
  return {problem_, discretisation_->with_steps(steps)};
}

GridFunction GlobalEquations::initial_guess() const {
  GridFunction guess{.y = Rows(problem_.size(), times()), .unknown = Vec::Zero(unknown_.count())};
  for (Eigen::Index n = 0; n < times(); ++n)
    guess.y.col(n) = taylor_part(discretisation_->left[n], discretisation_->right[n], guess.unknown);
  return guess;
}

Vec GlobalEquations::taylor_part(double left, double right, In unknown) const {
  Vec from_left(problem_.size()), from_right(problem_.size());
  taylor_.at(left, from_left);
  taylor_.at(right, from_right);
  for (const auto i : this->right().rows()) from_left[i] = from_right[i];
  if (unknown_.count() > 0) unknown_.add(unknown, left, right, from_left);
  return from_left;
}

Residual GlobalEquations::residual(Run& run, const GridFunction& guess) const {
  Residual result{.rows = initial_guess().y, .conditions = Vec(unknown_.count()), .f = Rows(guess.y)};
  for (Eigen::Index n = 0; n < guess.y.cols(); ++n)
    result.f.col(n) = run.rhs(discretisation_->left[n], guess.y.col(n));
  add_unknown(guess.unknown, result.rows);
  result.rows -= guess.y;
  left().integrate(result.f, result.rows);
  right().integrate(result.f, result.rows);
  if (problem_.conditions)
    problem_.conditions(guess.y.leftCols<1>().col(0), guess.y.rightCols<1>().col(0), result.conditions);
  return result;
}

void GlobalEquations::add_unknown(In unknown, Rows& y) const {
  if (unknown_.count() == 0) return;
  for (Eigen::Index n = 0; n < times(); ++n)
    unknown_.add(unknown, discretisation_->left[n], discretisation_->right[n], y.col(n));
}

UnknownInitialValues::UnknownInitialValues(const Problem& problem) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& component = problem.component(i);
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

void Linearisation::update(Run& run, const GridFunction& guess, const Residual& residual) {
  const auto& problem = equations_.problem();
  const auto size = problem.size();
  if (residual.conditions.size() > 0) differentiate_conditions(guess, residual.conditions);
  if (is_linear(problem) && jacobians_.size() > 0) return;
  jacobians_.resize(size * size, is_linear(problem) ? 1 : guess.y.cols());
  const Vec sizes = guess.y.cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index n = 0; n < jacobians_.cols(); ++n) {
    const double t = equations_.discretisation().left[n];
    Eigen::Map<Matrix> jacobian(jacobians_.col(n).data(), size, size);
    if (evaluate_jacobian(problem, t, guess.y.col(n), jacobian)) continue;
    difference_jacobian_of_rhs(run, problem, t, guess.y.col(n), residual.f.col(n), sizes, jacobian);
  }
  left_ = equations_.left().factors(jacobians_);
  right_ = equations_.right().factors(jacobians_);
}

void Linearisation::differentiate_conditions(const GridFunction& guess, const Vec& conditions) {
  const Vec start = guess.y.col(0), end = guess.y.rightCols<1>();
  const Vec sizes = guess.y.cwiseAbs().rowwise().maxCoeff();
  const auto& problem = equations_.problem();
  Vec result(conditions.size());
  by_start_.resize(conditions.size(), problem.size());
  by_end_.resize(conditions.size(), problem.size());
  const auto from_start = [&](const Vec& y) -> const Vec& {
    problem.conditions(y, end, result);
    return result;
  };
  const auto from_end = [&](const Vec& y) -> const Vec& {
    problem.conditions(start, y, result);
    return result;
  };
  const auto everywhere = [](const Vec&) { return true; };
  difference_jacobian(from_start, everywhere, start, conditions, sizes, by_start_);
  difference_jacobian(from_end, everywhere, end, conditions, sizes, by_end_);
}

Linearisation::LeftHandSides Linearisation::left_hand_sides(const GridFunction& x) const {
  Rows f(x.y.rows(), x.y.cols());
  for (Eigen::Index n = 0; n < f.cols(); ++n) f.col(n).noalias() = -jacobian(n) * x.y.col(n);
  Rows added = Rows::Zero(f.rows(), f.cols());
  equations_.add_unknown(x.unknown, added);
  Rows rows = x.y - added;
  equations_.left().integrate(f, rows);
  equations_.right().integrate(f, rows);
  return {std::move(rows), conditions(x.y)};
}

void Linearisation::forward_backward_sweep(const Rows& given, Rows& y) const {
  left_->solve(given, y);
  right_->solve(given, y);
}

Rows Linearisation::block_diagonal_solution(const Rows& given) const {
  Rows y(given.rows(), given.cols());
  left_->solve_block_diagonal(given, y);
  right_->solve_block_diagonal(given, y);
  return y;
}

Vec Linearisation::conditions(const Rows& y) const {
  if (equations_.unknown_count() == 0) return {};
  return by_start_ * y.col(0) + by_end_ * y.rightCols<1>();
}

std::size_t Linearisation::bytes() const {
  const auto of_sides = (left_ ? left_->bytes() : 0) + (right_ ? right_->bytes() : 0);
  return of_sides + sizeof(double) * static_cast<std::size_t>(jacobians_.size());
}

}  // namespace fde
