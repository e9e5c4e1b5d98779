#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepping/run.hpp"

namespace fde {

// df/dy at y by forward differences, where evaluate(y) gives f; one column a component of y. A component that
// is small beside its size, as it is where it changes its sign, is moved by a part of that; sizes of 0 and
// values of 0 leave |y|, or 1.
template <class Evaluate>
void forward_differences(Evaluate evaluate, Vec y, In f, In sizes, OutMatrix result) {
  const double relative_step = std::sqrt(std::numeric_limits<double>::epsilon());
  const double largest = y.lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double value = y[i];
    double size = std::max(std::abs(value), sizes[i]);
    if (size == 0.0) size = largest > 0.0 ? largest : 1.0;
    y[i] += relative_step * size;
    result.col(i) = (evaluate(y) - f) / (y[i] - value);
    y[i] = value;
  }
}

// The same of a run's right-hand side at t.
inline void difference_rhs(Run& run, double t, In y, In f, In sizes, OutMatrix result) {
  forward_differences([&](const Vec& shifted) -> const Vec& { return run.rhs(t, shifted); }, y, f, sizes,
                      result);
}

}  // namespace fde
