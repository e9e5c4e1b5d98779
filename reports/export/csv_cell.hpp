// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {

// RFC 4180.
inline constexpr std::string_view csv_line_end = "\r\n";

// Appends a cell: quotes are doubled, numbers are those of the results file to the last bit, NULL is empty.
void append_csv(std::string& line, const Cell& cell);

}  // namespace fde::bench
