#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/switches.hpp"
#include "stepping/run.hpp"

namespace fde {

// df/dy at y by differences, where evaluate(y) gives f. A component that is small beside its size, as it is
// where it changes its sign, is moved by a part of that; sizes of 0 and values of 0 leave |y|, or 1. It is
// moved forwards, or backwards where smooth(y) does not hold ahead.
template <class Evaluate, class Smooth>
void differences(Evaluate evaluate, Smooth smooth, Vec y, In f, In sizes, OutMatrix result) {
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

// The same of a run's right-hand side at t, without leaving the side of a switch or the domain.
inline void difference_rhs(Run& run, const Problem& problem, double t, In y, In f, In sizes,
                           OutMatrix result) {
  const auto here = sides(problem, t, y);
  differences([&](const Vec& shifted) -> const Vec& { return run.rhs(t, shifted); },
              [&](const Vec& shifted) {
                return sides(problem, t, shifted) == here && problem.domain.contains(t, shifted);
              },
              y, f, sizes, result);
}

}  // namespace fde
