// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fde::reference {

double first_part(const Problem& problem, const std::vector<Matrix>& weights, const Matrix& jacobian) {
  constexpr double small = 0.1;
  double change = 0.0;
  for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
    if (is_algebraic(problem.components[static_cast<std::size_t>(i)])) continue;
    const Matrix& weight = weights[static_cast<std::size_t>(i)];
    change =
        std::max(change, jacobian.row(i).cwiseAbs().sum() * weight.cwiseAbs().rowwise().sum().maxCoeff());
  }
  if (!(change > small) || !std::isfinite(change)) return 1.0;
  return std::exp2(-std::ceil(std::log2(change / small)));
}

std::vector<Matrix> reduced(const Problem& problem, std::vector<Matrix> weights, double part) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!is_algebraic(problem.components[i])) weights[i] *= part;
  return weights;
}

}  // namespace fde::reference
