// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <optional>

#include "fdebench/reference/special_functions/numbers/double_double.hpp"

namespace fde::reference {

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

// 1/Gamma(x) with relative error few_ulps, also next to a pole of Gamma.
long double reciprocal_gamma_of(const DoubleDouble& x);

// Largest accepted relative error: with the rounding to double at most 6.5 ulp.
inline constexpr long double quick_tolerance = 0x1.8p-51L;

// E_{alpha,beta}(z) for Im z >= 0 in about a microsecond: trapezoidal sum and residues in vectors of
// double-doubles, for large |z| the terms in z^-1 and z^-2 peeled off (forms.hpp). Almost all errors are
// below 1e-20 of the terms. nullopt where there is no bound: |beta| above about 50, or phases of e^s* above
// 2^39.
std::optional<QuickValue> mittag_leffler_quick(double alpha, const DoubleDouble& beta,
                                               std::complex<double> z);

}  // namespace fde::reference
