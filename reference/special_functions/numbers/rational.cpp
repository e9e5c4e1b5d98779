// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/numbers/rational.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace fde::reference {

Rational shortest_decimal(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument(fmt::format("'{}' is not a finite decimal number", x));
  return decimal_fraction(fmt::format("{}", x));
}

Rational decimal_fraction(const std::string& decimal) {
  const std::size_t e = decimal.find_first_of("eE"), point = decimal.find('.');
  std::string digits = decimal.substr(0, e);
  int exponent = e == std::string::npos ? 0 : std::stoi(decimal.substr(e + 1));
  if (point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  using boost::multiprecision::mpz_int;
  const bool negative = digits.front() == '-';
  const std::size_t first = digits.find_first_not_of("-0");
  if (first == std::string::npos) return {0};
  const mpz_int mantissa(digits.substr(first));
  const mpz_int scale = boost::multiprecision::pow(mpz_int(10), static_cast<unsigned>(std::abs(exponent)));
  const Rational size = exponent < 0 ? Rational(mantissa, scale) : Rational(mpz_int(mantissa * scale));
  return negative ? Rational(-size) : size;
}

Rational fraction_of(const BigReal& x) {
  Rational fraction;
  mpfr_get_q(fraction.backend().data(), x.backend().data());
  return fraction;
}

template <>
BigReal rounded<BigReal>(const Rational& x) {
  BigReal value;
  mpfr_set_q(value.backend().data(), x.backend().data(), MPFR_RNDN);
  return value;
}

template <>
long double rounded<long double>(const Rational& x) {
  mpfr_t value;  // NOLINT(cppcoreguidelines-pro-type-member-init,modernize-avoid-c-arrays): the type of mpfr
  mpfr_init2(value, std::numeric_limits<long double>::digits);
  mpfr_set_q(value, x.backend().data(), MPFR_RNDN);
  const long double result = mpfr_get_ld(value, MPFR_RNDN);
  mpfr_clear(value);
  return result;
}

int ceiling(const Rational& x) {
  return -boost::multiprecision::mpz_int(numerator(floor(-x))).convert_to<int>();
}

Rational floor(const Rational& x) {
  const Rational whole(boost::multiprecision::mpz_int(numerator(x) / denominator(x)));  // towards 0
  return whole > x ? Rational(whole - 1) : whole;
}

}  // namespace fde::reference
