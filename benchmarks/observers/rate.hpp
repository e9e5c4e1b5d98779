#pragma once

#include <cstddef>
#include <span>

namespace fde {

struct ErrorAt {
  double h, error;
};

// A straight line through log(error) against log(h).
struct Fit {
  double slope = 0.0;        // the observed rate
  double correlation = 0.0;  // of the two logarithms
  std::size_t points = 0;    // used; 0: too few for a slope
};

// Least squares over the points whose error is above rounding (1e-12, or 1e-12 of the largest error where
// that is above 1). Fewer than three of them: no fit, points = 0.
Fit fit_rate(std::span<const ErrorAt> points);

}  // namespace fde
