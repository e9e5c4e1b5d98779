#pragma once

#include <cstddef>
#include <string_view>

namespace fde {

bool is_digit(char c);
bool is_letter(char c);
bool is_in_name(char c);  // a letter, a digit or _

// A decimal, a name, one character of an operation or bracket, or the end, which is empty.
struct FormulaToken {
  std::string_view text{};
  std::size_t place = 0;
};

// The first one from a place on; blanks are passed over.
FormulaToken next_token(std::string_view text, std::size_t from);

}  // namespace fde
