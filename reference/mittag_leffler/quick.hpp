#pragma once

#include <complex>
#include <optional>

#include "numbers/double_double.hpp"

namespace fde {

// A value and a bound of the modulus of its error, before the rounding to double.
struct QuickValue {
  std::complex<long double> value;
  long double error;
};

inline QuickValue operator+(const QuickValue& a, const QuickValue& b) {
  return {a.value + b.value, a.error + b.error};
}

// Relative error of a few operations in long double.
inline constexpr long double few_ulps = 16.0L * std::numeric_limits<long double>::epsilon();

// 1/Gamma(x) to few_ulps, with the distance from a pole of Gamma to all its digits.
long double reciprocal_gamma_of(const DoubleDouble& x);

// Relative error that is good enough: with the rounding to double at most 6.5 ulp.
inline constexpr long double quick_tolerance = 0x1.8p-51L;

// E_{alpha,beta}(z) for Im z >= 0 in about a microsecond: trapezoidal sum and residues in vectors of
// double-doubles, |z|^-1 and |z|^-2 peeled off for large |z|. Almost all errors are below 1e-20 of the terms.
// Empty where that cannot be bounded: |beta| beyond about 50, or phases of e^s* beyond 2^39.
std::optional<QuickValue> mittag_leffler_quick(double alpha, const DoubleDouble& beta,
                                               std::complex<double> z);

}  // namespace fde
