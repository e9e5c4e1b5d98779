#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "numbers/real.hpp"

namespace fde {

// Exact fractions: orders and coefficients given as decimals add, multiply and cancel without rounding.
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

// The shortest decimal that names x: 0.1 becomes one tenth. Throws std::invalid_argument unless x is finite.
Rational exact_decimal(double x);

// The nearest Real.
template <class Real>
Real rounded(const Rational& x);

// The smallest whole number that is not below x.
int ceiling(const Rational& x);

}  // namespace fde
