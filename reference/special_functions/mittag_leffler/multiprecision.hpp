// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {

// Arguments of E_{alpha,beta}(z) with Im z >= 0.
struct MittagLefflerArguments {
  BigReal alpha, beta;
  BigComplex z;

  [[nodiscard]] bool real() const { return imag_part<BigReal>(z) == 0; }
};

// E_{alpha,beta}(z) to a relative accuracy of `digits` digits, with a bound of its error: the discretisation
// error by ContourBound plus the rounding errors of all terms. read() returns the arguments rounded to the
// current precision; places: decimal_places() of alpha and beta. Precondition:
// Precision(contour_precision(digits)) is in force. Throws std::runtime_error if that accuracy is out of
// reach.
Bounded<BigReal> mittag_leffler_multiprecision(int digits, int places,
                                               const std::function<MittagLefflerArguments()>& read);

}  // namespace fde::reference
