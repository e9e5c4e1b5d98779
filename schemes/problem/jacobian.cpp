// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/jacobian.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

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
