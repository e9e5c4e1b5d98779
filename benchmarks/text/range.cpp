// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fde::bench {

bool Range::contains(double value) const {
  return std::isfinite(value) && (open_low ? value > low : value >= low) &&
         (open_high ? value < high : value <= high);
}

std::string Range::text() const {
  const bool below = low > any_number.low, above = high < any_number.high;
  if (!below && !above) return "a finite number";
  if (!above) return fmt::format("a finite number {} {}", open_low ? "above" : "of at least", low);
  if (!below) return fmt::format("a finite number {} {}", open_high ? "below" : "of at most", high);
  return fmt::format("a number in {}{}, {}{}", open_low ? '(' : '[', low, high, open_high ? ')' : ']');
}

std::string CountRange::text() const { return fmt::format("a whole number from {} to {}", lowest, highest); }

}  // namespace fde::bench
