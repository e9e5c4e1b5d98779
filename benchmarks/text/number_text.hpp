// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/text/range.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {

// The whole text as a number; nullopt if it is not a number or is out of the range of double.
std::optional<double> try_parse_number(std::string_view text);
// Whether the text is a finite decimal number, with an exponent of any size.
bool is_decimal(std::string_view text);
// "underflows double, whose least number is 5e-324, and " or the overflow equivalent if the text is a decimal
// number out of the range of double; otherwise empty.
std::string double_range_message(std::string_view text);
// "1,2,5" as numbers, "" as an empty list; nullopt if a part is not a number.
std::optional<std::vector<double>> try_parse_numbers(std::string_view text);

// Parse numbers. Each throws std::invalid_argument naming the argument, the text and what is allowed.

double parse_number(std::string_view name, std::string_view text, const Range& allowed);
int parse_count(std::string_view name, std::string_view text, int lowest, int highest);

// Parses "1,2,5".
std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed);
// The parts between commas; one empty part for "".
std::vector<std::string> split_list(std::string_view text);

// "0.1:0.9:0.1" gives the decimals FIRST, FIRST + STEP, ... up to LAST, each an exact decimal: "3e-1". Throws
// std::invalid_argument if one of the three is missing or has more than 15 digits, if STEP is 0 or has the
// wrong sign, or if there are more than `most` values.
std::vector<std::string> expand_decimal_range(std::string_view name, std::string_view text, std::size_t most);

// Throws Refusal: "NAME = TEXT: must be ALLOWED", with double_range_message() in front of
// "must".
[[noreturn]] void reject_text(std::string_view name, std::string_view text, std::string_view allowed);

}  // namespace fde::bench
