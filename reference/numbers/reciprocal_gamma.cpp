#include "numbers/reciprocal_gamma.hpp"

namespace fde {

void add_reciprocal_gamma(Sum<BigReal>& sum, const BigComplex& factor, const BigReal& x, const BigReal& size,
                          const BigReal& factor_ulps) {
  const BigReal whole = round(x), rounding = 4 * size * epsilon<BigReal>();
  if (whole <= 0 && abs(BigReal(x - whole)) <= rounding) return;
  sum.add(BigComplex(factor * reciprocal_gamma(x)),
          BigReal((factor_ulps + 12 + 4 * size) * epsilon<BigReal>()));
  if (x > 0.5) return;
  // The slope of 1/Gamma is at most this; next to a pole of Gamma it makes nearly all of the error.
  const BigReal slope = gamma(BigReal(1 - x)) * (2 + log(BigReal(2 + abs(x))));
  sum.error += size_of(factor) * slope * rounding;
}

}  // namespace fde
