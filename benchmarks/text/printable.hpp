// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fde::bench {

// Whether the text is well-formed UTF-8 (RFC 3629: no overlong forms, surrogates or code points beyond
// 10FFFF) without control characters.
bool is_printable(std::string_view text);

// The text without blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

// Names separated by commas; a comma in parentheses is part of a name: "x,D(x,0.5)" has two names.
std::vector<std::string> split_names(std::string_view text);
// The name without what readers of CSV take for the end of a cell or a formula: "D(x,0.6)" is "Dx_0.6".
std::string plain_name(std::string_view name);
// The text as one word of a shell: in single quotes, unless it has letters, digits and @%+=:,./_- only.
std::string shell_word(std::string_view text);
// The header line of CSV: a name that contains a comma is quoted.
std::string csv_names(const std::vector<std::string>& names);

}  // namespace fde::bench
