// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/poles.hpp"

#include <variant>

#include "fdebench/reference/linear/linear_system.hpp"

namespace fde::bench {
namespace {

// The rows without loads, from rest.
std::optional<reference::LinearSystem> linear_part_of(const Problem& problem) {
  constexpr Eigen::Index most_rows = 12;
  const auto* linear = std::get_if<DenseLinearPart>(&problem.derivatives);
  const bool has_history = !problem.delays.lags.empty() || !problem.resets.empty();
  if (linear == nullptr || has_history || has_right_rows(problem) || problem.size() > most_rows)
    return std::nullopt;
  reference::LinearSystem system{.orders = {}, .initial = {}, .matrix = linear->matrix};
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.component(i).order;
    system.orders.push_back(order);
    system.initial.emplace_back(problem.is_algebraic(i) ? 0 : initial_count(order), 0.0);
    if (problem.is_algebraic(i)) system.matrix(i, i) += 1.0;  // 0 = f_i as x_i = x_i + f_i
  }
  return system;
}

}  // namespace

std::optional<std::vector<reference::CharacteristicZero>> poles_of(const Scene& scene) {
  if (scene.reference.zeros) return scene.reference.zeros();
  const auto system = linear_part_of(scene.problem);
  if (!system) return std::nullopt;
  return reference::linear_reference(*system).zeros();
}

}  // namespace fde::bench
