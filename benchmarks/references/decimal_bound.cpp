// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/decimal_bound.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace fde::bench {
namespace {

// -inf for 0. The error is far below the difference of two numbers with two digits.
long double log10_of(const std::string& bound) {
  const auto e = bound.find('e');
  const long double mantissa = std::stold(bound.substr(0, e));
  const long double exponent = e == std::string::npos ? 0.0L : std::stold(bound.substr(e + 1));
  return std::isnan(mantissa) ? std::numeric_limits<long double>::infinity()
                              : std::log10(mantissa) + exponent;
}

}  // namespace

std::string bound_column(const std::string& of) { return of.empty() ? "bound" : "bound_" + of; }

std::string bound_text(double bound) {
  constexpr double upwards = 1.06;
  return fmt::format("{:.2g}", upwards * bound);
}

// The decimal differs from the double by less than a unit in the last place, of which long double resolves a
// thousandth.
double bound_of_decimal(double value, double bound) {
  constexpr double upwards = 1.01;
  if (!std::isfinite(value) || !std::isfinite(bound)) return bound;
  const long double text = std::stold(fmt::format("{:.17g}", value));
  return bound + upwards * static_cast<double>(std::abs(text - static_cast<long double>(value)));
}

bool is_finite_bound(const std::string& bound) {
  return log10_of(bound) < std::numeric_limits<long double>::infinity();
}

const std::string& larger_bound(const std::string& a, const std::string& b) {
  return log10_of(a) < log10_of(b) ? b : a;
}

}  // namespace fde::bench
