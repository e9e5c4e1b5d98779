// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace fde::bench {

// The precision of a decimal number as written. Places are powers of ten: 12.50 has four digits, first place
// 1 and last place -2. Zero has no significant digit.
struct DecimalPrecision {
  int digits = 0;  // from the first nonzero digit to the last digit written
  int first_place = 0;
  int last_place = 0;
};

// nullopt if the text is no decimal number like -12.50 or 1e-9, or its exponent exceeds a million.
std::optional<DecimalPrecision> decimal_precision(std::string_view text);

}  // namespace fde::bench
