#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "certificate/points.hpp"
#include "mittag_leffler/mittag_leffler.hpp"

namespace fde::certificate {

// What the library says at one point against the enclosure. Of the errors, upper bounds.
struct Judgement {
  Point point;
  std::string re, im, radius;     // certified: the value is within radius of (re, im)
  std::complex<double> computed;  // by the double face
  double bound = 0.0;             // that it states
  double ulps = 0.0;              // |error| in units of the last place of |E|
  double conditioned_ulps = 0.0;  // the same near a zero in those of |z E'|; else ulps
  std::vector<std::string> faults;
  double ball_seconds = 0.0, double_seconds = 0.0, digits_seconds = 0.0;
};

constexpr double allowed_ulps = 8.0;

// The two faces under judgement; those of the library unless a test puts wrong ones here.
struct Faces {
  std::function<MittagLefflerValue(const Point&)> in_double;
  std::function<DecimalComplex(const Point&, int digits)> in_digits;
};
Faces library_faces();

// Judges the double face: error inside the stated bound; at most 8 ulp of |E|, or near a zero 8 ulp of |z
// E'|; infinite only where the value overflows. And, for digits > 0, the face with that many digits: error
// inside the stated bound, and the bound at most 10^(1-digits) |E|.
//
// Near a zero means |E| <= |z E'| / 4 and h <= 5/8, where h = |E E''| / |E'|^2 tends to 1 - 1/m at a zero of
// multiplicity m: E_{2,3}(-x) = (1 - cos sqrt x)/x has double zeros, and for alpha close to 2 they are almost
// double. An exponential has h = 1 however steep it is.
Judgement judge(const Point& point, int digits, const Faces& faces = library_faces());

// All digits of a double as a decimal text.
std::string exact_text(double x);

}  // namespace fde::certificate
