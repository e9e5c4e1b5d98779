// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <string>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// A value and a bound of the modulus of its error.
template <class Real>
struct Bounded {
  Complex<Real> value;
  Real bound;
};

// A real number as decimal text, with as many significant digits as its bound supports but at most `digits`.
// The bound includes the rounding of the text. A value not larger than its bound is written as 0.
struct DecimalText {
  std::string value;
  BigReal bound;
};
DecimalText to_decimal_text(const BigReal& value, const BigReal& bound, int digits);
std::string to_bound_text(const BigReal& bound);  // two digits, rounded up

// The nearest double and a bound that includes the rounding to it; the bound is infinite where the value
// overflows. A multiprecision value not larger than its bound becomes 0.
struct BoundedDouble {
  std::complex<double> value;
  double bound;
};
BoundedDouble to_double(const Complex<long double>& value, long double error);
BoundedDouble to_double(const Bounded<BigReal>& x);

}  // namespace fde::reference
