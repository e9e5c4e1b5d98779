// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

namespace {

template <class... Alternatives>
bool tells(const Problem& problem) {
  return (std::holds_alternative<Alternatives>(problem.derivatives) || ...);
}

void evaluate(const NoDerivatives& /*given*/, double /*t*/, In /*y*/, OutMatrix /*jacobian*/) {}
void evaluate(const DenseJacobian& given, double t, In y, OutMatrix jacobian) { given.at(t, y, jacobian); }
void evaluate(const SparseJacobian& given, double t, In y, OutMatrix jacobian) {
  SparseMatrix entries(y.size(), y.size());
  given.at(t, y, entries);
  jacobian = Matrix(entries);
}
void evaluate(const DenseLinearPart& given, double /*t*/, In /*y*/, OutMatrix jacobian) {
  jacobian = given.matrix;
}
void evaluate(const SparseLinearPart& given, double /*t*/, In /*y*/, OutMatrix jacobian) {
  jacobian = Matrix(given.matrix);
}

}  // namespace

bool has_algebraic_rows(const Problem& problem) {
  return std::ranges::any_of(problem.components, is_algebraic);
}

std::vector<Eigen::Index> algebraic_rows(const Problem& problem) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < problem.size(); ++i)
    if (problem.is_algebraic(i)) rows.push_back(i);
  return rows;
}

Vec orders_of(const Problem& problem) {
  return Vec::NullaryExpr(problem.size(), [&](Eigen::Index i) { return problem.component(i).order; });
}

Vec rhs_at(const Problem& problem, double t, In y) {
  Vec f(problem.size());
  problem.rhs(t, y, f);
  return f;
}

bool is_linear(const Problem& problem) {
  return problem.switching_functions.empty() && tells<DenseLinearPart, SparseLinearPart>(problem);
}

bool has_sparse_jacobian(const Problem& problem) { return tells<SparseJacobian, SparseLinearPart>(problem); }

bool has_jacobian(const Problem& problem) { return !tells<NoDerivatives>(problem); }

bool evaluate_jacobian(const Problem& problem, double t, In y, OutMatrix jacobian) {
  std::visit([&](const auto& given) { evaluate(given, t, y, jacobian); }, problem.derivatives);
  return has_jacobian(problem);
}

const SparseMatrix& sparse_jacobian_at(const Problem& problem, double t, In y, SparseMatrix& buffer) {
  if (const auto* part = std::get_if<SparseLinearPart>(&problem.derivatives)) return part->matrix;
  buffer.resize(y.size(), y.size());
  std::get<SparseJacobian>(problem.derivatives).at(t, y, buffer);
  buffer.makeCompressed();
  return buffer;
}

double longest_step(const Problem& problem, double t) {
  double longest = std::numeric_limits<double>::infinity();
  for (const auto& limit : problem.step_limits)
    if (t < limit.to) longest = std::min(longest, std::max(limit.from - t, limit.longest));
  return longest;
}

std::size_t initial_count(double order) { return static_cast<std::size_t>(std::max(std::ceil(order), 1.0)); }

double smallest_order(const Problem& problem) {
  double order = 1.0;
  for (const auto& component : problem.components)
    if (!is_algebraic(component)) order = std::min(order, component.order);
  return order;
}

bool has_right_rows(const Problem& problem) {
  return std::ranges::any_of(problem.components,
                             [](const auto& component) { return component.side == Side::right; });
}

bool is_two_sided(const Problem& problem) { return problem.conditions || has_right_rows(problem); }

bool is_solved_by_shooting(const Problem& problem) { return problem.conditions && !has_right_rows(problem); }

Eigen::Index unknown_count(const Problem& problem) {
  Eigen::Index count = 0;
  for (const auto& component : problem.components) {
    const auto given = component.initial.size(), needed = initial_count(component.order);
    if (given < needed) count += static_cast<Eigen::Index>(needed - given);
  }
  return count;
}

Problem with_initial_values(Problem problem, In unknown) {
  Eigen::Index next = 0;
  for (auto& [order, initial, side] : problem.components)
    while (initial.size() < initial_count(order)) initial.push_back(unknown[next++]);
  problem.conditions = {};
  return problem;
}

Problem with_some_initial_values(const Problem& problem) {
  if (!problem.conditions) return problem;
  return with_initial_values(problem, Vec::Ones(unknown_count(problem)));
}

TaylorPart::TaylorPart(const Problem& problem) {
  std::size_t powers = 1;
  for (const auto& component : problem.components) powers = std::max(powers, component.initial.size());
  coefficients_.setZero(problem.size(), static_cast<Eigen::Index>(powers));
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& initial = problem.component(i).initial;
    double factorial = 1.0;
    for (std::size_t k = 0; k < initial.size(); factorial *= static_cast<double>(++k)) {
      coefficients_(i, static_cast<Eigen::Index>(k)) = initial[k] / factorial;
    }
  }
}

void TaylorPart::at(double t, Out value) const {
  const Eigen::Index last = coefficients_.cols() - 1;
  for_each_component(coefficients_.rows(), [&](Eigen::Index i) {
    double sum = coefficients_(i, last);
    for (Eigen::Index k = last; k-- > 0;) sum = coefficients_(i, k) + t * sum;
    value[i] = sum;
  });
}

Vec taylor_part(const Problem& problem, double t) {
  const TaylorPart part(problem);
  Vec value(problem.size()), right(problem.size());
  part.at(t, value);
  part.at(problem.end - t, right);
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (problem.component(i).side == Side::right) value[i] = right[i];
  }
  return value;
}

std::vector<double> breaking_points(const Problem& problem) {
  std::vector<double> times;
  std::ranges::set_union(problem.jump_times, problem.kink_times, std::back_inserter(times));
  return times;
}

std::vector<bool> switch_signs(const Problem& problem, double t, In y) {
  std::vector<bool> positive;
  for (const auto& one : problem.switching_functions) positive.push_back(one(t, y) > 0.0);
  return positive;
}

Matrix jacobian_at(const Problem& problem, double t, Vec y) {
  Matrix jacobian(y.size(), y.size());
  if (evaluate_jacobian(problem, t, y, jacobian)) return jacobian;
  Vec above(y.size()), below(y.size());
  for (Eigen::Index j = 0; j < y.size(); ++j) {
    const double value = y[j], shift = 0x1p-18 * std::max(1.0, std::abs(value));
    y[j] = value + shift;
    problem.rhs(t, y, above);
    y[j] = value - shift;
    problem.rhs(t, y, below);
    y[j] = value;
    jacobian.col(j) = (above - below) / (2.0 * shift);
  }
  return jacobian;
}

}  // namespace fde
