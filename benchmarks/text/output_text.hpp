// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fde::bench {

// Formats of what commands print; the page has its own of numbers in reports/page/numbers.js.

// 1.2e-7; 0 for 0.
std::string error_text(double error);

// 12.3 µs, 4.56 ms, 78.9 s; three significant digits.
std::string time_text(double seconds);

// Suffix for the time of a whole process: " of the wall clock"; otherwise empty.
std::string_view clock_note(bool wall_clock);

// 8192, 1 234 567 with narrow spaces; from 1e9 on 1.2e9.
std::string count_text(double count);

// The number rounded to two significant digits: 35 000 for 34567.
std::string rough_count_text(double count);

// The text with other texts in place of some characters.
std::string replaced(std::string_view text, const std::map<char, std::string_view>& replacements);

// The rows with cells padded to the widest of their column, with `gap` blanks between them.
using TableRow = std::vector<std::string>;
std::string aligned(const std::vector<TableRow>& rows, std::size_t gap);

}  // namespace fde::bench
