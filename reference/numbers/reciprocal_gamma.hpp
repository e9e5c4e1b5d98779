#pragma once

#include "numbers/real.hpp"

namespace fde {

// Adds factor / Gamma(x), x being put together from numbers of that size. Arguments have as many decimal
// places as the working precision has digits at most, so that an x within rounding of a whole number is that
// number.
void add_reciprocal_gamma(Sum<BigReal>& sum, const BigComplex& factor, const BigReal& x, const BigReal& size,
                          const BigReal& factor_ulps = BigReal(0));

}  // namespace fde
