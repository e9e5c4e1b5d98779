// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fde::bench {

// Texts for a terminal. Texts are ASCII but for what a user gave.

enum class Colour { bold, red, yellow, green };
std::string in_colour(std::string_view text, Colour colour, bool shown);  // unchanged unless shown

// Where the last column begins in a row of a table, "  name  description"; npos if the line is none.
std::size_t description_of_row(std::string_view line);

// Breaks paragraphs, which blank lines separate, into lines of up to `columns` characters, each indented by
// `indent` blanks. A line that begins with blanks is a row of a table, whose last column is wrapped, or stays
// as it is. Ends with a newline.
std::string wrapped(std::string_view text, int columns, int indent = 0);

// "  NAME   description" where the name fits into `width` characters, otherwise the name on a line of its
// own; the description is wrapped and aligned.
std::string wrapped_item(std::string_view name, std::string_view description, int width, int columns,
                         bool bold);

}  // namespace fde::bench
