// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/initial_step_size.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/stepping/error_tolerance.hpp"

namespace fde {
namespace {

// As parts of the end. A component that starts from 0 has no correct digits after a first step, however
// short. None are required while (length / end)^order, which estimates its size relative to its later size,
// is below short_enough.
constexpr double short_enough = 1e-14;
constexpr double shortest_first = 1e-290;

bool asks_digits(const Component& component, double part_of_end) {
  return part_of_end > shortest_first && std::pow(part_of_end, component.order) > short_enough;
}

}  // namespace

bool exempt_from_relative_tolerance(const Problem& problem, In start, double part_of_end) {
  bool any = false;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const auto& component = problem.components[static_cast<std::size_t>(i)];
    if (start[i] != 0.0 || is_algebraic(component)) continue;
    if (asks_digits(component, part_of_end)) return false;
    any = true;
  }
  return any;
}

double initial_step_size(const Problem& problem, const Tolerance& accuracy, Run& run) {
  constexpr double shrink = 0.1;
  const ErrorTolerance allowed(accuracy);
  const TaylorPart taylor(problem);
  const Vec& start = run.start();
  // Infinite entries at the start count as 0: the values of f after the start suffice.
  const Vec f = run.rhs(0.0, start).unaryExpr([](double v) { return std::isfinite(v) ? v : 0.0; });
  Vec y(f.size()), unit(f.size());
  for (double length = std::min(problem.end, longest_step(problem, 0.0));; length *= shrink) {
    if (length <= shortest_first * problem.end) return length;
    taylor.at(length, y);
    for (Eigen::Index i = 0; i < unit.size(); ++i) {
      const double order = problem.components[static_cast<std::size_t>(i)].order;
      unit[i] = order > 0.0 ? std::pow(length, order) / std::tgamma(order + 1.0) : 0.0;
    }
    y += unit.cwiseProduct(f);
    if (!y.allFinite()) continue;
    const Vec change = unit.cwiseProduct(run.rhs(length, y) - f).cwiseAbs();
    const Vec limit = allowed.on_step(y.cwiseAbs().cwiseMax(start.cwiseAbs()), y.cwiseAbs());
    const auto passes = [&](Eigen::Index i) {
      const auto& component = problem.components[static_cast<std::size_t>(i)];
      return change[i] <= limit[i] ||
             (start[i] == 0.0 && std::isfinite(change[i]) && !asks_digits(component, length / problem.end));
    };
    bool passed = true;
    for (Eigen::Index i = 0; i < unit.size(); ++i) passed = passed && passes(i);
    if (passed) return length;
  }
}

}  // namespace fde
