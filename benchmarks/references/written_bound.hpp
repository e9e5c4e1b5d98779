#pragma once

#include <string>

namespace fde {

// Two digits of a bound, rounded up: rounding to nearest moves a number by at most five percent.
std::string bound_text(double bound);

// Of a value that is printed with 17 digits: a bound that holds for that decimal too, which is not quite the
// double.
double bound_of_text(double value, double bound);

// Whether a bound as it is written says something of a value: it is not "inf" or "nan".
bool is_finite_bound(const std::string& bound);

// The larger of two bounds written in decimal, as "0.012" or "1.2e-345": no double may hold their exponents.
// "inf" and "nan" are larger than all. Throws std::invalid_argument for a text that is no number.
const std::string& larger_bound(const std::string& a, const std::string& b);

}  // namespace fde
