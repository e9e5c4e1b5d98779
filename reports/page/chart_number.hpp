// SPDX-License-Identifier: MIT
#pragma once

namespace fde::bench {

// Rounds to the significant digits that a chart can show: a page contains thousands of these numbers.
inline constexpr int chart_digits = 5;
double rounded_for_chart(double value, int digits = chart_digits);

}  // namespace fde::bench
