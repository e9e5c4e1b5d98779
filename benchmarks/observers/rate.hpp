// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace fde::bench {

struct ErrorSample {
  double h, error;
};

// A least-squares line of log(error) against log(h).
struct Fit {
  double slope = 0.0;        // the observed rate
  double correlation = 0.0;  // of the two logarithms
  std::size_t points = 0;    // used; 0: too few for a slope
};

// Uses the points whose error is above rounding (1e-12, or 1e-12 of the largest error if that is above 1).
// With fewer than three such points there is no fit: points = 0.
Fit fit_rate(std::span<const ErrorSample> points);

}  // namespace fde::bench
