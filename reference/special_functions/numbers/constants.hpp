// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fde::reference {

inline constexpr double pi_double = std::numbers::pi;
inline constexpr long double pi_long = std::numbers::pi_v<long double>;
inline constexpr long double two_pi_long = 2.0L * pi_long;
inline constexpr double infinity_double = std::numeric_limits<double>::infinity();
inline constexpr long double infinity_long = std::numeric_limits<long double>::infinity();

// log(e^a + e^b)
inline double log_sum(double a, double b) {
  const double larger = std::max(a, b);
  if (std::isinf(larger)) return larger;
  return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

}  // namespace fde::reference
