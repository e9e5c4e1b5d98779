// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace fde::bench {

bool is_digit(char c);
bool is_letter(char c);
bool is_in_name(char c);  // a letter, a digit or _

// A decimal, a name, a single character of an operation or bracket, or the end (empty).
struct FormulaToken {
  std::string_view text{};
  std::size_t byte_offset = 0;
};

// The first token at or after a position; blanks are skipped.
FormulaToken next_token(std::string_view text, std::size_t from);

}  // namespace fde::bench
