// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

namespace fde {

// Stirling's correction sum_j B_2j / (2j (2j-1) x^(2j-1)) to ln Gamma(x), for x >= 16 (Abramowitz &
// Stegun 6.1.40).
inline long double stirling(long double x) {
  constexpr std::array<long double, 8> coefficients{1.0L / 12,    -1.0L / 360,      1.0L / 1260,
                                                    -1.0L / 1680, 1.0L / 1188,      -691.0L / 360360,
                                                    1.0L / 156,   -3617.0L / 122400};
  const long double y = 1 / (x * x);
  long double sum = 0;
  for (std::size_t j = coefficients.size(); j-- > 0;) sum = sum * y + coefficients[j];
  return sum / x;
}

// Gamma(k+g) / Gamma(k+1) for k >= 16; the leading terms of the two logarithms cancel analytically.
inline long double gamma_ratio(long double g, long double k) {
  const long double rest =
      (k + g - 0.5L) * std::log1p((g - 1) / (k + 1)) - (g - 1) + stirling(k + g) - stirling(k + 1);
  return std::pow(k + 1, g - 1) * std::exp(rest);
}

// The coefficient of zeta^k in (1-zeta)^(-g), Gamma(k+g) / (Gamma(g) k!) = (-1)^k binomial(-g, k).
inline long double binomial_weight(long double g, long double k) {
  if (k >= 16) return gamma_ratio(g, k) / std::tgamma(g);
  long double product = 1;
  for (long double j = 1; j <= k; ++j) product *= (j - 1 + g) / j;
  return product;
}

}  // namespace fde
