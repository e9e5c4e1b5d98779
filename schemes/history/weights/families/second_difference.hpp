// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fde {

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
