// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// Adds factor / Gamma(x) and its rounding error to sum. size: the sum of the moduli from which x was
// computed; factor_ulps: the relative error of factor, in ulps. Precondition: x has at most as many decimal
// places as the working precision has digits, so that an x within rounding of an integer is that integer.
void add_reciprocal_gamma(BoundedSum<BigReal>& sum, const BigComplex& factor, const BigReal& x,
                          const BigReal& size, const BigReal& factor_ulps = BigReal(0));

}  // namespace fde::reference
