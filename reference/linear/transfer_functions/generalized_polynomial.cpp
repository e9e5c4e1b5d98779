// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/generalized_polynomial.hpp"

namespace fde::reference {
namespace {

constexpr int most_folded = 40;  // larger integer powers and arguments are not multiplied out

bool is_whole_up_to(const Rational& x, int most) {
  return denominator(x) == 1 && x >= Rational(-most) && x <= Rational(most);
}

}  // namespace

Coefficient coefficient_of_power(const Rational& base, const Rational& power) {
  if (base == 1) return {{Factor{}, Rational(1)}};
  if (!is_whole_up_to(power, most_folded)) return {{Factor{base, power, 1}, Rational(1)}};
  const int times = ceiling(power);
  Rational product(1);
  for (int i = 0; i < std::abs(times); ++i) product *= base;
  return {{Factor{}, times < 0 ? Rational(1 / product) : product}};
}

Coefficient coefficient_of_gamma(const Rational& argument) {
  if (argument < 1 || !is_whole_up_to(argument, most_folded)) return {{Factor{1, 0, argument}, Rational(1)}};
  Rational factorial(1);
  for (int k = 2; Rational(k) < argument; ++k) factorial *= k;
  return {{Factor{}, factorial}};
}

void add_term(GeneralizedPolynomial& sum, const Rational& exponent, const Coefficient& coefficient,
              const Rational& scale) {
  if (scale == 0) return;
  Coefficient& place = sum[exponent];
  for (const auto& [factor, fraction] : coefficient) {
    Rational& value = place[factor];
    value += scale * fraction;
    if (value == 0) place.erase(factor);
  }
  if (place.empty()) sum.erase(exponent);
}

void add_term(GeneralizedPolynomial& sum, const Rational& exponent, const Rational& coefficient) {
  add_term(sum, exponent, {{Factor{}, Rational(1)}}, coefficient);
}

template <class Real>
ValueAndScale<Real> rounded(const Coefficient& coefficient) {
  using std::abs, std::pow;
  ValueAndScale<Real> sum{Real(0), Real(0)};
  for (const auto& [factor, fraction] : coefficient) {
    Real term = rounded<Real>(fraction);
    if (factor.power != 0) term *= pow(rounded<Real>(factor.base), rounded<Real>(factor.power));
    if (factor.gamma != 1) term *= gamma(rounded<Real>(factor.gamma));
    sum.value += term;
    sum.size += abs(term);
  }
  return sum;
}

template ValueAndScale<long double> rounded(const Coefficient&);
template ValueAndScale<BigReal> rounded(const Coefficient&);

}  // namespace fde::reference
