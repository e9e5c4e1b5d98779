// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// Adds factor / Gamma(x) and its rounding error to sum. size: the sum of the moduli from which x was
// computed; factor_ulps: the relative error of factor, in ulps. Precondition: x has at most as many decimal
// places as the working precision has digits, so that an x within rounding of an integer is that integer.
void add_reciprocal_gamma(BoundedSum<BigReal>& sum, const BigComplex& factor, const BigReal& x,
                          const BigReal& size, const BigReal& factor_ulps = BigReal(0));

// log|Gamma(x)|. std::lgamma stores the sign in a global variable, a data race between threads.
inline double log_gamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

}  // namespace fde::reference
