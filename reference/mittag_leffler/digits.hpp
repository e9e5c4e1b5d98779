#pragma once

#include <functional>

#include "numbers/bounded.hpp"

namespace fde {

// Arguments of E_{alpha,beta}(z) with Im z >= 0.
struct MittagLefflerArguments {
  BigReal alpha, beta;
  BigComplex z;

  [[nodiscard]] bool real() const { return imag_part<BigReal>(z) == 0; }
};

// The value to a relative accuracy of so many digits, with a bound of its error: the contour neglects at most
// what ContourBound says, and every term counts its rounding. Call under
// Precision(contour_precision(digits)); read gives the arguments at the precision of the moment. Places: of
// alpha and beta after the decimal point. Throws std::runtime_error where that accuracy is out of reach.
Bounded<BigReal> mittag_leffler_to(int digits, int places,
                                   const std::function<MittagLefflerArguments()>& read);

}  // namespace fde
