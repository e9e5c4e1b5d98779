#include "missing_values.hpp"

namespace fde {

MissingValues::MissingValues(const Problem& problem) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& component = problem.components[static_cast<std::size_t>(i)];
    for (std::size_t k = component.initial.size(); k < initial_count(component.order); ++k)
      list_.push_back({i, component.side, k});
  }
}

void MissingValues::add(In values, double left, double right, Out y) const {
  Eigen::Index next = 0;
  for (const auto& [component, side, power] : list_) {
    double term = values[next++];
    for (std::size_t k = 1; k <= power; ++k)
      term *= (side == Side::left ? left : right) / static_cast<double>(k);
    y[component] += term;
  }
}

}  // namespace fde
