#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/range.hpp"

namespace fde {

// The whole text as a number; none where it is not one.
std::optional<double> number_in(std::string_view text);
// "1,2,5" as numbers, "" as no number at all; none where a part is not a number.
std::optional<std::vector<double>> numbers_in(std::string_view text);

// Texts into numbers. Each throws std::invalid_argument naming the argument, the text and what is allowed.

double parse_number(std::string_view name, std::string_view text, const Range& allowed);
int parse_count(std::string_view name, std::string_view text, int lowest, int highest);

// "1,2,5" into its numbers.
std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed);
std::vector<std::string> split_list(std::string_view text);

// Throws std::invalid_argument: "NAME = TEXT: must be ALLOWED".
[[noreturn]] void reject_text(std::string_view name, std::string_view text, std::string_view allowed);

}  // namespace fde
