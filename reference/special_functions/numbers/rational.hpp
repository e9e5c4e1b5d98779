// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// Exact fractions: orders and coefficients given as decimals add, multiply and cancel without rounding.
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

// The shortest decimal that rounds to x: 0.1 becomes 1/10. Throws std::invalid_argument unless x is finite.
Rational shortest_decimal(double x);

// The number that a decimal is, such as -1.5e-3. Precondition: the text is one.
Rational decimal_fraction(const std::string& decimal);

// The number that x is.
Rational fraction_of(const BigReal& x);

// x rounded to the nearest Real.
template <class Real>
Real rounded(const Rational& x);

// The smallest integer >= x.
int ceiling(const Rational& x);
// The largest whole number that is at most x.
Rational floor(const Rational& x);

}  // namespace fde::reference
