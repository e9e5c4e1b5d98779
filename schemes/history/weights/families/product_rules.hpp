// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fde {

// What the families share whose rules integrate an interpolant exactly.

// k^g - (k-1)^g = k^g (1 - (1 - 1/k)^g), without its cancellation.
inline long double power_difference(long double g, long double k) {
  if (k == 1) return 1;
  return -std::pow(k, g) * std::expm1(g * std::log1p(-1 / k));
}

// D(s) = (exp(s) - 1) / s = int_0^1 exp(v s) dv: the mean of exp(-s (t - v)) over v in [0, 1] is D(s) exp(-s
// t).
inline double step_mean(double s) { return s == 0.0 ? 1.0 : std::expm1(s) / s; }

// One more factor D(s) for orders above 1, where the sum of exponentials represents differences of weights.
inline double difference_mean(double order, double s) { return order > 1.0 ? step_mean(s) : 1.0; }

}  // namespace fde
