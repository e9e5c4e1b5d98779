#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/range.hpp"

namespace fde {

// The whole text as a number; none where it is not one, or is beyond double.
std::optional<double> number_in(std::string_view text);
// Whether it is a decimal number, of any exponent.
bool is_decimal(std::string_view text);
// "underflows double, whose least number is 5e-324, and " or the like for a decimal number beyond double;
// else empty.
std::string beyond_double(std::string_view text);
// "1,2,5" as numbers, "" as no number at all; none where a part is not a number.
std::optional<std::vector<double>> numbers_in(std::string_view text);

// Texts into numbers. Each throws std::invalid_argument naming the argument, the text and what is allowed.

double parse_number(std::string_view name, std::string_view text, const Range& allowed);
int parse_count(std::string_view name, std::string_view text, int lowest, int highest);

// "1,2,5" into its numbers.
std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed);
std::vector<std::string> split_list(std::string_view text);

// "0.1:0.9:0.1" into the decimals FIRST, FIRST + STEP, ... that are not beyond LAST, each exact: "0.3".
// Throws where one of the three is missing or has more than 15 digits, STEP is 0 or leads away from LAST, or
// there are more decimals than that.
std::vector<std::string> decimals_of_range(std::string_view name, std::string_view text, std::size_t most);

// Throws std::invalid_argument: "NAME = TEXT: must be ALLOWED", and what is beyond_double() before that.
[[noreturn]] void reject_text(std::string_view name, std::string_view text, std::string_view allowed);

}  // namespace fde
