#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem.hpp"

namespace fde {

// df/dy at y by forward differences, where evaluate(y) gives f; one column a component of y.
template <class Evaluate>
void forward_differences(Evaluate evaluate, Vec y, In f, OutMatrix result) {
  const double relative_step = std::sqrt(std::numeric_limits<double>::epsilon());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double value = y[i];
    y[i] += relative_step * std::max(std::abs(value), 1.0);
    result.col(i) = (evaluate(y) - f) / (y[i] - value);
    y[i] = value;
  }
}

}  // namespace fde
