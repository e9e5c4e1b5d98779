// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fdebench/schemes/history/weights/family.hpp"

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

// Completes a family whose weights are integrals of t^(-g), g <= 1, and apply to increments of y.
constexpr WeightFamily increment_family(WeightFamily row) {
  using Real = long double;
  row.acts_on_increments = true;
  row.first_sample_weight = [](Real /*g*/, Real /*n*/) -> Real { return 0; };
  row.weight_at_order_one = 0.0;
  row.step_factor = [](Real g) { return std::tgamma(2 - g); };
  return row;
}

// Weights of second differences, by which a quadratic interpolant differs from the linear one: on a step of
// length 1 the slope of this difference goes from -1 to 1.

// (1-g) int_0^1 (far - v)^(-g) (2v - 1) dv for far > 1, by a series of positive terms.
inline long double second_difference_weight(long double g, long double far) {
  constexpr long double negligible = 1e-21L;
  long double power = 1, sum = 0, term = 1;
  for (int k = 1; term > negligible * sum; ++k) {
    power *= (k - 1 + g) / (k * far);
    term = power * k / ((k + 1) * (k + 2));
    sum += term;
  }
  return (1 - g) * std::pow(far, -g) * sum;
}

// int_0^1 (1 - 2v) exp(-s v) dv = exp(-s/2) i_1(s/2), i_1 the modified spherical Bessel function.
inline double second_difference_mean(double s) {
  const double z = 0.5 * s;
  if (z > 1.0) return (z - 1.0 + (z + 1.0) * std::exp(-2.0 * z)) / (2.0 * z * z);
  double term = z / 3.0, sum = term;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= z * z / (2.0 * k * (2.0 * k + 3.0));
    sum += term;
  }
  return std::exp(-z) * sum;
}

}  // namespace fde
