// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fde::bench {

// The column of the bound of a column, and of the largest bound: "bound_x", "bound".
std::string bound_column(const std::string& of = "");

// A bound in two digits, rounded up: rounding to nearest changes a number by at most five percent.
std::string bound_text(double bound);

// The bound for a value printed with 17 digits, including the difference between that decimal and the double.
double bound_of_decimal(double value, double bound);

// Whether a bound in decimal is finite: not "inf" or "nan".
bool is_finite_bound(const std::string& bound);

// The larger of two bounds written in decimal, as "0.012" or "1.2e-345", whose exponent may be out of the
// range of double. "inf" and "nan" are larger than all others. Throws std::invalid_argument for a text that
// is not a number.
const std::string& larger_bound(const std::string& a, const std::string& b);

}  // namespace fde::bench
