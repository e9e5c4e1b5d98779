#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include "numbers/bounded.hpp"

namespace fde {

// Digits to ask for so that a double comes out rounded almost correctly.
inline constexpr int double_digits = 17;
// The relative error that an evaluation in long double may leave to the rounding of its value to double.
inline constexpr long double double_tolerance = 5e-16L;

// What an evaluation with some working digits comes to.
struct WorkingEstimate {
  Bounded<BigReal> known;
  BigReal scale =
      BigReal(0);        // size of what the value was put together from; 0: the value never counts as zero
  bool settled = false;  // more digits would not tell more: the value is infinite, or 0 by structure
};

struct DigitSearch {
  int wanted;                                        // decimal digits of relative accuracy
  int guard;                                         // working digits beyond those, at first
  std::function<int(int digits, int missing)> next;  // the working digits after these, which lacked so many
  int zero_digits = 40;                              // a value so many digits below its scale counts as zero
};

// The values at the last working digits.
struct Raised {
  std::vector<Bounded<BigReal>> values;
  int digits;
  std::optional<BigReal> too_large{};  // the largest bound of those that are; empty: no bound is too large
};

// The working digits are raised to so many at most.
constexpr int most_digits(int wanted) { return 4 * wanted + 1000; }

// Raises the working digits until every bound is 10^-wanted of its value, or of what of its scale counts as
// zero; or until there are most_digits(wanted) of them. Call under a Precision; evaluate sets its own.
Raised raise_digits(const DigitSearch& search,
                    const std::function<std::vector<WorkingEstimate>(int digits)>& evaluate);

// For values that are not accurate at the most digits: "no accurate value in reach: bound ... at ... digits".
std::runtime_error out_of_digits(const Raised& raised);

}  // namespace fde
