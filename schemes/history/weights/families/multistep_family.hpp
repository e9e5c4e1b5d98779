// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fdebench/schemes/history/weights/family.hpp"

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

// Members of families whose weights are Grunwald-Letnikov weights convolved with the filter of a
// MultistepRule.

inline constexpr double below_rounding = 1e-18;

// An upper bound of the number of filter coefficients that are not negligible.
inline std::size_t filter_length(const MultistepRule& rule) {
  if (rule.decay == 0.0) return 3;
  // For orders above 1 the coefficients have an additional factor k^p, p < 1.
  return static_cast<std::size_t>(1.25 * std::log(below_rounding) / std::log(rule.decay)) + 8;
}

template <const MultistepRule& rule>
std::vector<double> filter_of(double g) {
  const auto extended = multistep_filter<long double>(rule, g, filter_length(rule));
  std::vector<double> filter(extended.begin(), extended.end());
  while (filter.size() > 1 && std::abs(filter.back()) < below_rounding) filter.pop_back();
  return filter;
}

template <const MultistepRule& rule>
std::vector<long double> first_weights_of(long double g, std::size_t count) {
  auto w = multistep_weights<long double>(rule, g, count + 1);
  w.erase(w.begin());
  return w;
}

// The convolution of filter and Grunwald-Letnikov weights, each of which follows from the one before.
template <const MultistepRule& rule>
long double weight_of(long double g, long double k) {
  const auto filter = multistep_filter<long double>(rule, g, filter_length(rule));
  long double sum = 0, binomial = binomial_weight(g, k);
  for (const long double factor : filter) {
    sum += factor * binomial;
    if (k == 0) break;
    binomial *= k / (k - 1 + g);
    k -= 1;
  }
  return sum;
}

template <const MultistepRule& rule>
long double first_weight(long double g) {
  using Real = long double;
  return std::pow(Real(rule.base[0]) / rule.denominator, rule.exponent * g) * correction<Real>(rule, g)[0];
}

// The principal power is the right branch: every linear factor of the base is in the right half plane, and
// for all of these rules their product is not on the negative axis.
template <const MultistepRule& rule>
ComplexValue regular_part_of(double g, ComplexValue mu) {
  const ComplexValue zeta = std::exp(mu);
  ComplexValue base = 0.0, q = 0.0;
  const auto scaled = scaled_base<double>(rule);
  const auto factors = correction<double>(rule, g);
  for (std::size_t i = scaled.size(); i-- > 0;) base = base * zeta + scaled[i];
  for (std::size_t i = factors.size(); i-- > 0;) q = q * zeta + factors[i] / factors[0];
  return std::pow(base, rule.exponent * g) * q;
}

template <const MultistepRule& rule>
constexpr WeightFamily multistep_family(std::string_view id, std::string_view title) {
  return {.id = id,
          .title = title,
          .weight = weight_of<rule>,
          .first_weights = first_weights_of<rule>,
          .step_factor = first_weight<rule>,
          .filter = filter_of<rule>,
          .multistep = &rule,
          .regular_part = regular_part_of<rule>};
}

}  // namespace fde
