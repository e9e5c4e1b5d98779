// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "certificate/points.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::reference::certificate {

// Comparison of the library's values at one point with the enclosure.
struct PointCheck {
  Point point;
  std::string re, im, radius;            // enclosure: the value is within radius of (re, im)
  std::complex<double> value_in_double;  // in double
  double bound = 0.0;                    // stated with `value_in_double`
  double ulps = 0.0;                     // |error| in units of the last place of |E|
  double conditioned_ulps = 0.0;  // near a zero, |error| in units of the last place of |z E'|; else ulps
  std::vector<std::string> failures;
  double ball_seconds = 0.0, double_seconds = 0.0, digits_seconds = 0.0;
};

constexpr double allowed_ulps = 8.0;

// The two overloads under test, in double and in digits; tests of check_point() replace them by wrong ones.
struct Implementations {
  std::function<MittagLefflerValue(const Point&)> evaluate_in_double;
  std::function<DecimalComplex(const Point&, int digits)> in_digits;
};
Implementations library_implementations();

// Checks the value in double: its error is within the stated bound and at most 8 ulp of |E|, or near a zero 8
// ulp of |z E'|; it is infinite only where E overflows. For digits > 0 also checks the value with that many
// digits: its error is within the stated bound, and the bound is at most 10^(1-digits) |E|.
//
// Near a zero means |E| <= |z E'| / 4 and h <= 5/8, where h = |E E''| / |E'|^2 tends to 1 - 1/m at a zero of
// multiplicity m: E_{2,3}(-x) = (1 - cos sqrt x)/x has double zeros, and for alpha close to 2 they are almost
// double. An exponential of any rate has h = 1.
PointCheck check_point(const Point& point, int digits,
                       const Implementations& faces = library_implementations());

// All digits of a double as a decimal text.
std::string exact_text(double x);

}  // namespace fde::reference::certificate
