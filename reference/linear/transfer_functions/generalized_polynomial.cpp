// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/generalized_polynomial.hpp"

#include <bit>

namespace fde::reference {

namespace {

constexpr int most_folded = 40;  // larger integer powers and arguments are not multiplied out

bool is_whole_up_to(const Rational& x, int most) {
  return denominator(x) == 1 && x >= Rational(-most) && x <= Rational(most);
}

bool is_fraction(const Coefficient& coefficient) {
  const Factor& factor = coefficient.begin()->first;
  return coefficient.size() == 1 && factor.power == 0 && factor.gamma == 1;
}

// Adds sign * a * b. Precondition: of two coefficients at least one is rational.
void add_product(GeneralizedPolynomial& sum, const GeneralizedPolynomial& a, const GeneralizedPolynomial& b,
                 int sign) {
  for (const auto& [left, of_left] : a) {
    for (const auto& [right, of_right] : b) {
      const bool plain = is_fraction(of_right);
      const Rational& scale = (plain ? of_right : of_left).begin()->second;
      add_term(sum, Rational(left + right), plain ? of_left : of_right, Rational(sign * scale));
    }
  }
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

GeneralizedPolynomial determinant(const PolynomialMatrix& matrix) {
  // Minors of the rows so far, by the bit set of their columns.
  std::map<unsigned, GeneralizedPolynomial> minors{{0U, {}}}, next;
  add_term(minors[0U], 0, Rational(1));
  for (const auto& row : matrix) {
    next.clear();
    for (const auto& [columns, minor] : minors) {
      for (std::size_t j = 0; j < row.size(); ++j) {
        if ((columns >> j & 1U) != 0U || row[j].empty()) continue;
        const int sign = std::popcount(columns >> j) % 2 == 0 ? 1 : -1;
        add_product(next[columns | 1U << j], minor, row[j], sign);
      }
    }
    std::erase_if(next, [](const auto& entry) { return entry.second.empty(); });
    minors.swap(next);
  }
  return minors.empty() ? GeneralizedPolynomial{} : minors.begin()->second;
}

}  // namespace fde::reference
