// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde::bench {

// 70 digits: 50 remain after the 1e18-fold cancellation at k = 1e9.
using Exact = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<70>>;

inline Exact power(const Exact& base, const Exact& exponent) {
  return base == 0 ? Exact(0) : pow(base, exponent);
}

// The weight of the second difference on a step that ends at the distance `near`, scaled like L1 (Gao, Sun &
// Zhang 2014, twice their b).
inline Exact published_second_difference(const Exact& g, const Exact& near) {
  const Exact far = near + 1;
  return 2 / (2 - g) * (pow(far, 2 - g) - pow(near, 2 - g)) - (pow(far, 1 - g) + pow(near, 1 - g));
}

// The weights by the published formulas. Throws std::invalid_argument naming the family where there is none.
inline Exact published_weight(const WeightTable& table, std::int64_t lag) {
  const Exact g = table.order, k = lag;
  if (table.family == &families::rectangle) return power(k, g) - power(k - 1, g);
  if (table.family == &families::trapezoid)
    return power(k + 1, g + 1) - 2 * power(k, g + 1) + power(k - 1, g + 1);
  if (table.family == &families::grunwald_letnikov) return exp(lgamma(k + g) - lgamma(g) - lgamma(k + 1));
  if (table.family == &families::l1) return pow(k + 1, 1 - g) - pow(k, 1 - g);
  if (table.family == &families::l1_second_difference) return published_second_difference(g, k);
  const Exact sigma = 1 - g / 2;
  if (table.family == &families::l2_1_sigma) return pow(k + sigma, 1 - g) - pow(k - 1 + sigma, 1 - g);
  if (table.family == &families::l2_1_sigma_second_difference)
    return published_second_difference(g, k + sigma);
  throw std::invalid_argument(std::string(table.family->id));
}

inline Exact published_first_sample_weight(double order, std::int64_t n) {
  const Exact g = order, k = n;
  return power(k - 1, g + 1) - (k - 1 - g) * power(k, g);
}

// |value - exact| in units in the last place of exact.
inline double ulps(double value, const Exact& exact) {
  const auto rounded = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return static_cast<double>(abs(Exact(value) - exact) / ulp);
}

}  // namespace fde::bench
