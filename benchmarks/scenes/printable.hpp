#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fde {

// Well-formed UTF-8 (RFC 3629: no overlong forms, surrogates or code points beyond 10FFFF) without control
// characters.
bool prints(std::string_view text);

// Without the blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

// Names between commas; a comma in round brackets is part of a name: "x,D(x,0.5)" are two.
std::vector<std::string> split_names(std::string_view text);
// As the first line of CSV: a name with a comma is in quotes.
std::string csv_names(const std::vector<std::string>& names);

}  // namespace fde
