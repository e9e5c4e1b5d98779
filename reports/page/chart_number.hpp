// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {

// Rounds to the significant digits that a chart can show: a page contains thousands of these numbers.
inline constexpr int chart_digits = 5;
inline double rounded_for_chart(double value, int digits = chart_digits) { return rounded(value, digits); }

}  // namespace fde::bench
