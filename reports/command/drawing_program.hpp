// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace fde::bench {

// Both write a figure, `out` in messages. They throw std::invalid_argument with the first error line of the
// program if it fails, and if it is not installed.

// Runs a script in node with one argument, the request. Returns the first line that it printed, "" if none.
std::string draw_by_node(const std::filesystem::path& script, const std::filesystem::path& request,
                         const std::string& out);

// Converts a figure from SVG to PDF, the file `out`, by rsvg-convert.
void print_on_paper(const std::filesystem::path& svg, const std::string& out);

}  // namespace fde::bench
