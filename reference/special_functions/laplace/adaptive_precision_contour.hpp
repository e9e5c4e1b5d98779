// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/reference/special_functions/numbers/adaptive_precision.hpp"

// increase_digits() for sums on contour_for(). `extra` working digits are added to contour_precision(), for
// the phase of e^s at poles with large |s|. Precondition of both functions: a Precision is in force.
namespace fde::reference {

// Values on contour_for(digits); called with the Precision for it in force.
using EvaluateAt = std::function<std::vector<BoundedSum<BigReal>>(int digits)>;

// Raises the working digits until every value has the wanted relative accuracy or max_working_digits() is
// reached. The bounds are estimates: 4 times the difference of two contours, for `digits` and for clearly
// more digits, plus rounding. A value more than 40 digits smaller than its summands counts as zero: its
// accuracy is then relative to their size.
std::vector<Bounded<BigReal>> increase_digits_by_comparison(int wanted_digits, int extra,
                                                            const EvaluateAt& evaluate);

// The same for one value whose BoundedSum::error is a bound of the whole error, and which never counts as
// zero. Throws std::runtime_error where max_working_digits() does not suffice.
Bounded<BigReal> increase_digits_by_bound(int wanted_digits, int extra,
                                          const std::function<BoundedSum<BigReal>(int digits)>& evaluate);

}  // namespace fde::reference
