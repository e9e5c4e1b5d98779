// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "fdebench/benchmarks/measures/error_kind.hpp"

namespace fde::bench {

// Number formats of the report and the command line.

// 1.2e-7; 0 for 0.
std::string error_text(double error);

// 12.3 µs, 4.56 ms, 78.9 s; three significant digits.
std::string time_text(double seconds);

// Suffix for the time of a whole process: " of the wall clock"; otherwise empty.
std::string_view clock_note(bool wall_clock);

// 123 B, 4.56 kB, 78.9 MB; powers of 1000.
std::string bytes_text(double bytes);

// 8192, 1 234 567 with narrow spaces; from 1e9 on 1.2e9.
std::string count_text(double count);

// The number rounded to two significant digits: 35 000 for 34567.
std::string rough_count_text(double count);

// "maximum error", "relative error at the end", "mixed maximum error".
std::string error_title(const ErrorKind& kind);

}  // namespace fde::bench
