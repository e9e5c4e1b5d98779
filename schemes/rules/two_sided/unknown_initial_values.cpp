// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/unknown_initial_values.hpp"

namespace fde {

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
