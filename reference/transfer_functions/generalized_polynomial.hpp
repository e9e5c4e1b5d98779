#pragma once

#include <map>
#include <tuple>

#include "numbers/rational.hpp"

namespace fde {

// What a fraction may be multiplied by in the coefficient of a power: base^power * Gamma(gamma). Whole powers
// and whole arguments of Gamma are fractions themselves, see coefficient_of_power and coefficient_of_gamma.
struct Factor {
  Rational base{1}, power{0}, gamma{1};

  friend bool operator<(const Factor& a, const Factor& b) {
    return std::tie(a.base, a.power, a.gamma) < std::tie(b.base, b.power, b.gamma);
  }
};

// sum of fractions times factors, exactly: what cancels is gone, and an empty one is zero.
using Coefficient = std::map<Factor, Rational>;

// sum of coefficients times s^exponent, by exponent.
using GeneralizedPolynomial = std::map<Rational, Coefficient>;

Coefficient coefficient_of_power(const Rational& base, const Rational& power);  // base^power, base > 0
Coefficient coefficient_of_gamma(const Rational& argument);                     // Gamma(argument)

// Adds scale * coefficient * s^exponent; terms that cancel are removed.
void add_term(GeneralizedPolynomial& sum, const Rational& exponent, const Coefficient& coefficient,
              const Rational& scale);
void add_term(GeneralizedPolynomial& sum, const Rational& exponent, const Rational& coefficient);

// A number with the sum of the moduli it was put together from.
template <class Real>
struct Sized {
  Real value, size;
};
template <class Real>
Sized<Real> rounded(const Coefficient& coefficient);

}  // namespace fde
