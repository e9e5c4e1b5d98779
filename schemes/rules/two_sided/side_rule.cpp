// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/side_rule.hpp"

#include <algorithm>

namespace fde {

SideRule::SideRule(const Problem& problem, Side side) : right_(side == Side::right) {
  std::vector<Eigen::Index> algebraic;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& component = problem.component(i);
    if (component.side != side) continue;
    (is_algebraic(component) ? algebraic : rows_).push_back(i);
  }
  differential_count_ = std::ssize(rows_);
  rows_.insert(rows_.end(), algebraic.begin(), algebraic.end());
}

Eigen::Map<const Matrix> jacobian_at_time(const Matrix& jacobians, Eigen::Index time, Eigen::Index size) {
  return {jacobians.col(std::min(time, jacobians.cols() - 1)).data(), size, size};
}

}  // namespace fde
