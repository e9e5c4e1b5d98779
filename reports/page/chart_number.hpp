#pragma once

namespace fde {

// As many significant digits as a chart can show: a page has thousands of these numbers.
inline constexpr int chart_digits = 5;
double in_chart(double value, int digits = chart_digits);

}  // namespace fde
