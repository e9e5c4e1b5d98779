// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::reference {

// The irrational factor base^power * Gamma(gamma) of a coefficient. Integer powers and integer arguments of
// Gamma give rational numbers instead, see coefficient_of_power and coefficient_of_gamma.
struct Factor {
  Rational base{1}, power{0}, gamma{1};

  friend bool operator<(const Factor& a, const Factor& b) {
    return std::tie(a.base, a.power, a.gamma) < std::tie(b.base, b.power, b.gamma);
  }
};

// Exact sum of rational numbers times factors. Terms that cancel are removed; an empty sum is zero.
using Coefficient = std::map<Factor, Rational>;

// sum of coefficients times s^exponent, by exponent.
using GeneralizedPolynomial = std::map<Rational, Coefficient>;

Coefficient coefficient_of_power(const Rational& base, const Rational& power);  // base^power, base > 0
Coefficient coefficient_of_gamma(const Rational& argument);                     // Gamma(argument)

// Adds scale * coefficient * s^exponent; terms that cancel are removed.
void add_term(GeneralizedPolynomial& sum, const Rational& exponent, const Coefficient& coefficient,
              const Rational& scale);
void add_term(GeneralizedPolynomial& sum, const Rational& exponent, const Rational& coefficient);

// A number and the sum of the moduli of its summands.
template <class Real>
struct ValueAndScale {
  Real value, size;
};
template <class Real>
ValueAndScale<Real> rounded(const Coefficient& coefficient);

using PolynomialMatrix = std::vector<std::vector<GeneralizedPolynomial>>;  // rows

// The exact determinant of a square matrix of sums of powers, by expansion along the rows with every minor
// computed once: fast for sparse rows. Precondition: only one column has coefficients that are not rational.
GeneralizedPolynomial determinant(const PolynomialMatrix& matrix);

}  // namespace fde::reference
