// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/closed_forms/extremum.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

// Small differences are computed exactly, from decimals, and then rounded.
struct Arguments {
  BigReal alpha, one_minus_alpha, power, time, left;  // alpha, 1 - alpha, 2 alpha - 1, t, 1 - t

  Arguments(double alpha_text, double t_text)
      : Arguments(shortest_decimal(alpha_text), shortest_decimal(t_text)) {}
  Arguments(const Rational& a, const Rational& t)
      : alpha(rounded<BigReal>(a)),
        one_minus_alpha(rounded<BigReal>(Rational(1 - a))),
        power(rounded<BigReal>(Rational(2 * a - 1))),
        time(rounded<BigReal>(t)),
        left(rounded<BigReal>(Rational(1 - t))) {}
};

BigReal ulps_of_power(const BigReal& base, const BigReal& exponent) {
  return base == 0 ? BigReal(4) : BigReal(4 + 3 * abs(exponent) * (1 + abs(BigReal(log(base)))));
}

// Adds factor * (1 + first * sum_{k>0} c_k), c_1 = z, c_{k+1} = c_k z (top + k) / (bottom + k) for
// top <= bottom and 0 <= z <= 1/2: the remainder after a term is at most that term. ulps: relative error of
// factor.
void add_series(BoundedSum<BigReal>& sum, const BigReal& factor, const BigReal& ulps, const BigReal& first,
                const BigReal& top, const BigReal& bottom, const BigReal& z) {
  BigReal series(1), term = first * z;
  int k = 1;
  for (; term > epsilon<BigReal>() * series; ++k) {
    report_progress(static_cast<std::size_t>(k));
    series += term;
    term *= z * (top + k) / (bottom + k);
  }
  sum.add(BigComplex(BigReal(factor * series)), BigReal((ulps + 8 * k) * epsilon<BigReal>()));
  sum.error += 2 * factor * term;
}

// With z = t for t <= 1/2, and for t > 1/2 from the connection formula with z = 1 - t:
//   y = (2 alpha - 1)/alpha t^alpha 2F1(1 - alpha, 1; 1 + alpha; t)
//     = t^alpha 2F1(1 - alpha, 1; 2 - 2 alpha; 1 - t) - Gamma(alpha) Gamma(2 - 2 alpha) / Gamma(1 - alpha)
//       (1 - t)^(2 alpha - 1),
// where Gamma(2 d) / Gamma(d) = Gamma(1 + 2 d) / (2 Gamma(1 + d)) has no pole at d = 1 - alpha = 0.
BoundedSum<BigReal> value(const Arguments& x) {
  BoundedSum<BigReal> sum;
  const BigReal start = pow(x.time, x.alpha), ulps = ulps_of_power(x.time, x.alpha);
  if (x.time <= 0.5) {
    add_series(sum, BigReal(x.power / x.alpha * start), BigReal(ulps + 4),
               BigReal(x.one_minus_alpha / (1 + x.alpha)), x.one_minus_alpha, BigReal(1 + x.alpha), x.time);
    return sum;
  }
  add_series(sum, start, ulps, BigReal(0.5), x.one_minus_alpha, BigReal(2 * x.one_minus_alpha), x.left);
  const BigReal gammas = gamma(x.alpha) * gamma(BigReal(1 + 2 * x.one_minus_alpha)) /
                         (2 * gamma(BigReal(1 + x.one_minus_alpha)));
  sum.add(BigComplex(BigReal(-gammas * pow(x.left, x.power))),
          BigReal((24 + ulps_of_power(x.left, x.power)) * epsilon<BigReal>()));
  return sum;
}

BoundedSum<BigReal> derivative(const Arguments& x) {
  BoundedSum<BigReal> sum;
  if (x.left == 0 && x.one_minus_alpha > 0) {
    sum.add_infinite(BigComplex(1), BigReal(1));
    return sum;
  }
  const BigReal singular = x.one_minus_alpha == 0 ? BigReal(1) : BigReal(pow(x.left, -x.one_minus_alpha));
  sum.add(BigComplex(BigReal(x.power * gamma(x.alpha) * singular)),
          BigReal((16 + ulps_of_power(x.left, x.one_minus_alpha)) * epsilon<BigReal>()));
  return sum;
}

}  // namespace

Reference extremum_reference(double alpha) {
  if (!(alpha > 0.5 && alpha <= 1.0))
    throw std::invalid_argument(fmt::format("extremum: alpha = {} has to be in (0.5, 1]", alpha));
  const auto precise = [alpha](double t, int digits) {
    return std::vector{increase_digits_by_bound(digits, 0,
                                                [&](int) {
                                                  return value({alpha, t});
                                                }),
                       increase_digits_by_bound(digits, 0, [&](int) {
                         return derivative({alpha, t});
                       })};
  };
  return as_reference({.name = "extremum", .precise = precise, .end = 1.0});
}

}  // namespace fde::reference
