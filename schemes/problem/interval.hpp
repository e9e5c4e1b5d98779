// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace fde {

// A closed interval of real numbers, [low, high]; an end may be infinite. Every function below returns an
// interval that contains its value at all points of its arguments at which it is defined, and all real
// numbers where it is defined at none of them. Ends are rounded outwards: by one unit in the last place after
// an operation of IEEE arithmetic, by eight after a function of the C library, whose errors in glibc are at
// most five (glibc manual, "Errors in Math Functions"). No rounding mode is changed, which is slow and which
// compilers do not respect.
struct Interval {
  double low, high;

  // NOLINTNEXTLINE(google-explicit-constructor): numbers are intervals, as in every formula
  constexpr Interval(double point = 0.0) : low(point), high(point) {}
  constexpr Interval(double from, double to) : low(from), high(to) {}

  static constexpr Interval all() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double magnitude() const { return -low < high ? high : -low; }  // max |x|
};

// With both ends moved outwards by eight units in the last place.
Interval widened(const Interval& a);

Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
Interval operator/(const Interval& a, const Interval& b);
Interval operator-(const Interval& a);

Interval square(const Interval& a);
Interval pow(const Interval& base, const Interval& exponent);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
Interval atan2(const Interval& y, const Interval& x);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval sqrt(const Interval& a);
Interval abs(const Interval& a);
Interval sign(const Interval& a);
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
Interval gamma(const Interval& a);
Interval erf(const Interval& a);
Interval erfc(const Interval& a);
Interval floor(const Interval& a);
// (-1)^n (x - n) with the whole number n nearest to x.
Interval alternation(const Interval& a);

}  // namespace fde
