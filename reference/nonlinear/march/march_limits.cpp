// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/march_limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace fde::reference {

void require_supported(const Problem& problem) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("reference solution: " + what);
  };
  require(problem.end > 0.0 && std::isfinite(problem.end), "the end must be positive and finite");
  require(problem.size() > 0, "no components");
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const auto& component = problem.components[i];
    const double order = component.order;
    require(component.side == Side::left, fmt::format("component {} has a right derivative", i));
    require(is_algebraic(component) || (order > 0.0 && order <= 2.0),
            fmt::format("component {} needs an order in [0, 2], it has {}", i, order));
    require(component.initial.size() == initial_count(order),
            fmt::format("component {} needs ceil(order) initial values", i));
  }
}

}  // namespace fde::reference
