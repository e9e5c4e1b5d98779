// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/unit_increment.hpp"

#include <cmath>

namespace fde::reference {

Vec unit_increment(const Problem& problem, double length) {
  Vec increment(problem.size());
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.components[static_cast<std::size_t>(i)].order;
    increment[i] = std::pow(length, order) / std::tgamma(order + 1.0);
  }
  return increment;
}

}  // namespace fde::reference
