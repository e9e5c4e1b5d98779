// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/numbers/reciprocal_gamma.hpp"

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

// Gamma on [1, 2] to about the current precision, from the series of the lower incomplete gamma function,
//   gamma(x, N) = N^x e^-N sum_k N^k / (x (x+1) ... (x+k)),   Gamma(x) - gamma(x, N) <= 2 N^(x-1) e^-N.
// All terms are positive.
BigReal gamma_by_series(const BigReal& x) {
  const auto many = static_cast<unsigned>(std::numbers::ln10 * BigReal::default_precision()) + 1;
  constexpr unsigned terms = 4;  // upper limit of their number / N: they decrease from the N-th on
  const auto smallest = epsilon<BigReal>();
  BigReal term = 1 / x, sum = term;
  for (unsigned k = 1; k < many || term > smallest * sum; ++k) {
    report_progress(k, std::size_t{terms} * many);
    term *= many;
    term /= x + k;
    sum += term;
  }
  return sum * exp(BigReal(x * log(BigReal(many)) - many));
}

// Above this precision mpfr_gamma takes minutes and cannot be cancelled.
constexpr unsigned few_digits = 2000;

// Gamma(x), x >= 1/2; can be cancelled at any precision.
BigReal cancellable_gamma(const BigReal& x) {
  constexpr int guard_digits = 25;
  const unsigned digits = BigReal::default_precision();
  if (digits <= few_digits) return gamma(x);
  BigReal result;
  const Precision precision(static_cast<int>(digits) + guard_digits);
  BigReal argument, factor(1);
  mpfr_set(argument.backend().data(), x.backend().data(), MPFR_RNDN);
  if (argument < 1) {
    factor /= argument;
    argument += 1;
  }
  for (; argument > 2; report_progress(0)) {
    argument -= 1;
    factor *= argument;
  }
  const BigReal known = factor * gamma_by_series(argument);
  mpfr_set(result.backend().data(), known.backend().data(), MPFR_RNDN);
  return result;
}

// 1/Gamma(x), for x <= 1/2 by Gamma(x) Gamma(1-x) sin(pi x) = pi.
BigReal cancellable_reciprocal_gamma(const BigReal& x) {
  if (BigReal::default_precision() <= few_digits) return reciprocal_gamma(x);
  if (x > 0.5) return 1 / cancellable_gamma(x);
  const BigReal whole = round(x), beyond = x - whole;
  const bool even = BigReal(2 * round(BigReal(whole / 2))) == whole;
  const BigReal sine = sin(BigReal(pi<BigReal>() * beyond));
  return cancellable_gamma(BigReal(1 - x)) * (even ? sine : BigReal(-sine)) / pi<BigReal>();
}

}  // namespace

void add_reciprocal_gamma(BoundedSum<BigReal>& sum, const BigComplex& factor, const BigReal& x,
                          const BigReal& size, const BigReal& factor_ulps) {
  const BigReal whole = round(x), rounding = 4 * size * epsilon<BigReal>();
  if (whole <= 0 && abs(BigReal(x - whole)) <= rounding) return;
  sum.add(BigComplex(factor * cancellable_reciprocal_gamma(x)),
          BigReal((factor_ulps + 12 + 4 * size) * epsilon<BigReal>()));
  if (x > 0.5) return;
  // An upper bound of |(1/Gamma)'|; next to a pole of Gamma this part is nearly all of the error.
  const BigReal slope = cancellable_gamma(BigReal(1 - x)) * (2 + log(BigReal(2 + abs(x))));
  sum.error += norm1(factor) * slope * rounding;
}

}  // namespace fde::reference
