#pragma once

#include <functional>
#include <vector>

#include "numbers/bounded.hpp"

namespace fde {

// Raises the working digits until a value, whose error is a bound that needs no comparison, has the wanted
// relative accuracy. Extra digits are carried beyond those the contour needs, for the phase of e^s at poles
// far out. Call under a Precision. Throws std::runtime_error where 4 times the wanted digits and 1000 do not
// do.
Bounded<BigReal> raise_digits(int wanted_digits, int extra,
                              const std::function<Sum<BigReal>(int digits)>& evaluate);

// Values at so many working digits, under a Precision that the caller has set.
using EvaluateAt = std::function<std::vector<Sum<BigReal>>(int digits)>;

// Raises the working digits until every value has the wanted relative accuracy. The bound is by comparison:
// the same values from another contour at clearly more digits, plus rounding. A value more than 40 digits
// smaller than what it was put together from counts as zero: its accuracy is then relative to that size.
// Extra digits are carried beyond those the contour needs, for the phase of e^s at poles far out. Call under
// a Precision.
std::vector<Bounded<BigReal>> refine(int wanted_digits, int extra, const EvaluateAt& evaluate);

// Digits for which refine has to be called so that a double comes out rounded almost correctly.
inline constexpr int double_digits = 17;
// The relative error that the long double face may leave to the rounding of its value to double.
inline constexpr long double double_tolerance = 5e-16L;

}  // namespace fde
