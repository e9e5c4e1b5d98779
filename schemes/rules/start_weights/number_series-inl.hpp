// SPDX-License-Identifier: MIT
// Numbers, power series and special functions for starting weights, for any type of number: one
// multiprecision number, or several double-doubles at once. Included once for each vector target.

#if defined(FDE_NUMBER_SERIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_NUMBER_SERIES_INL
#undef FDE_NUMBER_SERIES_INL
#else
#define FDE_NUMBER_SERIES_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "fdebench/schemes/rules/start_weights/elementary_functions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// The number of terms of the asymptotic series below, and from which argument on they are used: the last term
// is about (2n)! / (2 pi from)^(2n).
template <class Real>
constexpr std::size_t stirling_terms = Real::digits <= 31   ? 20
                                       : Real::digits <= 46 ? 28
                                                            : 36;
template <class Real>
constexpr std::size_t stirling_from = Real::digits <= 31   ? 16
                                      : Real::digits <= 46 ? 26
                                                           : 36;

// A power series is given by its coefficients of 1, t, t^2, ...; coefficients that are not given are 0.

// The first `count` coefficients of (a_0 + a_1 t + ...)^exponent. first = a_0^exponent.
template <class Real>
Numbers<Real> power_of_series(const Numbers<Real>& a, const Real& exponent, const Real& first,
                              std::size_t count) {
  Numbers<Real> b(count), scaled(a.size());
  const Real one(1.0), inverse = one / a.each(0);
  for (std::size_t k = 1; k < a.size(); ++k) scaled.set(k, (exponent + one) * Real(k) * a.each(k));
  b.set(0, first);
  for (std::size_t n = 1; n < count; ++n) {
    SumOfProducts<Real> sum, rest;
    for (std::size_t k = 1; k < std::min(a.size(), n + 1); ++k) {
      sum.add(scaled.each(k), b.each(n - k));
      rest.add(a.each(k), b.each(n - k));
    }
    b.set(n, (sum.value() / Real(n) - rest.value()) * inverse);
  }
  return b;
}

// The first `count` coefficients of a b.
template <class Real>
Numbers<Real> product(const Numbers<Real>& a, const Numbers<Real>& b, std::size_t count) {
  Numbers<Real> c(count);
  for (std::size_t n = 0; n < count; ++n) {
    SumOfProducts<Real> sum;
    for (std::size_t k = n < b.size() ? 0 : n + 1 - b.size(); k < std::min(a.size(), n + 1); ++k)
      sum.add(a.each(k), b.each(n - k));
    c.set(n, sum.value());
  }
  return c;
}

// The series of the polynomial p at exp(-t).
template <class Real>
Numbers<Real> compose_with_exponential(const Numbers<Real>& p, std::size_t count) {
  Numbers<Real> series(count), terms = p;
  for (std::size_t k = 0; k < count; ++k) {
    Real sum(0.0);
    const Real factor = Real(-1.0) / Real(k + 1);
    for (std::size_t j = 0; j < p.size(); ++j) {
      sum = sum + terms.each(j);
      terms.set(j, terms.each(j) * (factor * Real(j)));
    }
    series.set(k, sum);
  }
  return series;
}

// The series of (1 - exp(-t)) / t.
template <class Real>
Numbers<Real> exponential_mean(std::size_t count) {
  Numbers<Real> mean(count);
  Real term(1.0);
  for (std::size_t k = 0; k < count; ++k) {
    mean.set(k, term);
    term = term / Real(-static_cast<double>(k + 2));
  }
  return mean;
}

// B_2i / (2i)! for i = 0, 1, ...: the coefficients of t/2 coth(t/2), a quotient of the series of cosh and
// sinh.
template <class Real>
const Numbers<Real>& bernoulli_ratios() {
  static const Numbers<Real> ratios = [] {
    constexpr std::size_t count = stirling_terms<Real> + 1;
    Numbers<Real> even(count), odd(count), quotient(count);
    Real term(1.0);  // 2^(-2i) / (2i)!
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) term = term / Real(4 * (2 * i - 1) * (2 * i));
      even.set(i, term);
      odd.set(i, term / Real(2 * i + 1));
    }
    for (std::size_t i = 0; i < count; ++i) {
      SumOfProducts<Real> sum;
      for (std::size_t k = 1; k <= i; ++k) sum.add(odd.each(k), quotient.each(i - k));
      quotient.set(i, even.each(i) - sum.value());
    }
    return quotient;
  }();
  return ratios;
}

// Gamma(x) for x > 0, by Stirling's series at x + stirling_from.
template <class Real>
Real gamma(const Real& x) {
  const auto& ratios = bernoulli_ratios<Real>();
  Real rising = x;
  for (std::size_t i = 1; i < stirling_from<Real>; ++i) rising = rising * (x + Real(i));
  const Real z = x + Real(stirling_from<Real>), square = Real(1.0) / (z * z);
  Real factor = Real(1.0) / z, sum(0.0);  // (2i-2)! z^(1-2i)
  for (std::size_t i = 1; i <= stirling_terms<Real>; ++i) {
    sum = sum + ratios.each(i) * factor;
    factor = factor * square * Real((2 * i - 1) * (2 * i));
  }
  const Real half(0.5), of_two_pi = half * log(Real(2.0) * Real::pi());
  return exp((z - half) * log(z) - z + of_two_pi + sum) / rising;
}

// zeta(-p-k) (-1)^k / k! for k < count, in rows of one vector, from the values of zeta at z = p+1+k:
//   zeta(1-z) = 2 (2 pi)^(-z) cos(pi z/2) Gamma(z) zeta(z),
// which the Euler-Maclaurin formula gives as a sum of terms without cancellation (DLMF 25.4.1, 25.2.9).
// powers: j^p in row j, j <= stirling_from. gamma = Gamma(p+1). Lanes with p = 0 are correct from k = 1 on.
template <class Real>
Numbers<Real> zeta_series(const Real& p, const Real& gamma, const Numbers<Real>& powers, std::size_t first,
                          std::size_t stride, std::size_t count) {
  constexpr std::size_t from = stirling_from<Real>, lanes = Real::lanes;
  const double tiny = std::pow(10.0, -Real::digits - 2.0);
  const auto& ratios = bernoulli_ratios<Real>();
  const Real one(1.0), two_pi = Real(2.0) * Real::pi(), by_square = one / Real(from * from);
  std::vector<double> integers((from + lanes) / lanes * lanes);
  std::iota(integers.begin(), integers.end(), 0.0);
  integers[0] = 1.0;
  Numbers<Real> values(count * lanes), terms((from + 1) * lanes), inverse(integers.size());
  for (std::size_t j = 0; j < inverse.size(); j += lanes)
    inverse.put(j, one / Real::of_doubles(&integers[j]));
  for (std::size_t j = 1; j <= from; ++j)
    terms.put(j * lanes, inverse.each(j) / powers.from(j * stride + first));  // j^(-p-1)
  Numbers<Real> shrinking(inverse.size());                                    // j^(-k)
  for (std::size_t j = 0; j < shrinking.size(); ++j) shrinking.set(j, one);
  // (p+m+1) (p+m+2) / from^2 in row m
  Numbers<Real> factors((count + 2 * stirling_terms<Real>)*lanes);
  Real next = p + one;
  for (std::size_t m = 0; m * lanes < factors.size(); ++m) {
    const Real after = next + one;
    factors.put(m * lanes, next * after * by_square);
    next = after;
  }
  const auto [sine, cosine] = sine_and_cosine(p * Real::pi() * Real(0.5));
  Real factor = Real(2.0) * gamma / (two_pi * exp(p * log(two_pi))), z = p + one;
  for (std::size_t k = 0; k < count; ++k) {
    const double first_negligible = std::pow(tiny, -1.0 / static_cast<double>(k + 1));
    const std::size_t end = first_negligible < from ? static_cast<std::size_t>(first_negligible) + 1 : from;
    SumOfProducts<Real> sum;
    for (std::size_t j = 1; j < end; ++j) sum.add(terms.from(j * lanes), shrinking.each(j));
    // sum_i B_2i/(2i)! z (z+1) ... (z+2i-2) from^(1-2i); fewer terms where the factor from^(-z) is small.
    const double digits = 1.0 - static_cast<double>(k) * std::log10(from) / Real::digits;
    const auto most = static_cast<std::size_t>(
        std::max(0.0, std::ceil(static_cast<double>(stirling_terms<Real>) * digits)));
    Real rest(0.0);
    for (std::size_t i = most; i > 0; --i) {
      rest = rest + ratios.each(i);
      if (i > 1) rest = rest * factors.from((k + 2 * i - 3) * lanes);
    }
    rest = Real(0.5) + rest * z * inverse.each(from) + Real(from) / (z - one);
    sum.add(rest * terms.from(from * lanes), shrinking.each(from));
    const Real turned = k % 2 == 0 ? sine : cosine;
    values.put(k * lanes, (k % 4 == 0 || k % 4 == 3 ? -turned : turned) * factor * sum.value());
    factor = factor * z / (two_pi * Real(k + 1));
    z = z + one;
    for (std::size_t j = 0; j < shrinking.size(); j += lanes)
      shrinking.put(j, shrinking.from(j) * inverse.from(j));
  }
  return values;
}

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
