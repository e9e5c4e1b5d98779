#pragma once

#include <functional>
#include <vector>

#include "numbers/raise_digits.hpp"

// Working digits raised at the precision of the contours that contour_for() gives. Extra digits are carried
// beyond those the contour needs, for the phase of e^s at poles far out. Call these under a Precision.
namespace fde {

// Values at so many working digits, under a Precision that the caller has set.
using EvaluateAt = std::function<std::vector<Sum<BigReal>>(int digits)>;

// Raises the working digits until every value has the wanted relative accuracy, or there are no more. The
// bound is by comparison: the same values at clearly more digits, which is another contour, plus rounding. A
// value more than 40 digits smaller than what it was put together from counts as zero: its accuracy is then
// relative to that size.
std::vector<Bounded<BigReal>> raise_by_comparison(int wanted_digits, int extra, const EvaluateAt& evaluate);

// The same for a value whose error is a bound that needs no comparison, and which never counts as zero.
// Throws std::runtime_error where the most digits do not do.
Bounded<BigReal> raise_by_bound(int wanted_digits, int extra,
                                const std::function<Sum<BigReal>(int digits)>& evaluate);

}  // namespace fde
