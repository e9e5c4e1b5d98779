#pragma once

#include <optional>
#include <string_view>

namespace fde {

// What the text of a decimal number says about its precision. Places are powers of ten: 12.50 has four
// digits, its first place is 1 and its last place -2. Zero has no significant digit.
struct WrittenNumber {
  int digits = 0;  // from the first one that is not 0 to the last one written
  int first_place = 0;
  int last_place = 0;
};

// nullopt: not a decimal number like -12.50 or 1e-9, or with an exponent beyond a million.
std::optional<WrittenNumber> read_written(std::string_view text);

}  // namespace fde
