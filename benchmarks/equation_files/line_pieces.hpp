// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// Where the bytes of a TOML string stand: a piece for each of its lines, and a new one behind each escape and
// each character of several bytes. `lines`: the file from the line of the string on; `opening`: the position
// of its first quote; `value`: the string without quotes and escapes. Columns count characters.
std::vector<LinePiece> line_pieces(std::string_view lines, TextPosition opening, std::string_view value);

}  // namespace fde::bench
