// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// df/dy at y by one-sided differences: evaluate(y) returns f; f is its value at y. The increment of component
// i is sqrt(eps) max(|y_i|, sizes_i); where both are 0, the largest |y_j| is used, or 1. It is positive, or
// negative where smooth(y) is false at the shifted point.
template <class Evaluate, class Smooth>
void difference_jacobian(Evaluate evaluate, Smooth smooth, Vec y, In f, In sizes, OutMatrix result) {
  const double relative_step = std::sqrt(std::numeric_limits<double>::epsilon());
  const double largest = y.lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double value = y[i];
    double size = std::max(std::abs(value), sizes[i]);
    if (size == 0.0) size = largest > 0.0 ? largest : 1.0;
    y[i] += relative_step * size;
    if (!smooth(y)) y[i] = value - relative_step * size;
    result.col(i) = (evaluate(y) - f) / (y[i] - value);
    y[i] = value;
  }
}

// The same for a run's right-hand side at t. The shifted points stay on the same sides of all switches and in
// the domain, where one of the two directions does.
inline void difference_jacobian_of_rhs(Run& run, const Problem& problem, double t, In y, In f, In sizes,
                                       OutMatrix result) {
  const auto here = switch_signs(problem, t, y);
  difference_jacobian([&](const Vec& shifted) -> const Vec& { return run.rhs(t, shifted); },
                      [&](const Vec& shifted) {
                        return switch_signs(problem, t, shifted) == here &&
                               problem.domain.contains(t, shifted);
                      },
                      y, f, sizes, result);
}

}  // namespace fde
