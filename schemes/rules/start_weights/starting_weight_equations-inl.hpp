// SPDX-License-Identifier: MIT
// The equations of the starting weights, in any type of number. Included once for each vector target.

#if defined(FDE_STARTING_WEIGHT_EQUATIONS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_STARTING_WEIGHT_EQUATIONS_INL
#undef FDE_STARTING_WEIGHT_EQUATIONS_INL
#else
#define FDE_STARTING_WEIGHT_EQUATIONS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/vectors.hpp"
#include "fdebench/schemes/rules/start_weights/number_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// The factors of omega of a rule of order g, in the variable of the generating function.
template <class Real>
struct RuleFactors {
  Real order;
  bool quotient;       // exponent -1: the base is in the denominator, as 1 - zeta is
  Numbers<Real> base;  // base / denominator
  Numbers<Real> q;     // q(1 - zeta) in powers of zeta

  explicit RuleFactors(const WeightTable& table)
      : order(table.order), quotient(table.family->multistep->exponent < 0) {
    const MultistepRule& rule = *table.family->multistep;
    std::size_t size = rule.base.size();
    while (rule.base[size - 1] == 0) --size;
    base = Numbers<Real>(size);
    for (std::size_t i = 0; i < size; ++i)
      base.set(i, Real(double(rule.base[i])) / Real(double(rule.denominator)));
    const auto in_u = [&](std::size_t i) {
      const auto& c = rule.corrections[i];
      return (Real(double(c[0])) + order * (Real(double(c[1])) + order * Real(double(c[2])))) / Real(24.0);
    };
    size = 3;
    while (rule.corrections[size - 1] == std::array<int, 3>{}) --size;
    q = Numbers<Real>(size);
    q.set(0, in_u(0) + in_u(1) + in_u(2));
    if (size > 1) q.set(1, -in_u(1) - Real(2.0) * in_u(2));
    if (size > 2) q.set(2, in_u(2));
  }

  // omega(0)
  [[nodiscard]] Real first() const {
    const Real power = exp(order * log(base.each(0)));
    return q.each(0) * (quotient ? Real(1.0) / power : power);
  }

  // a^(-g) b^(exponent g) q for the series of 1 - zeta, base and q in some variable. Precondition: a_0, b_0 >
  // 0.
  [[nodiscard]] Numbers<Real> combine(const Numbers<Real>& a, const Numbers<Real>& b,
                                      const Numbers<Real>& of_q, std::size_t count) const {
    const auto power = [&](const Numbers<Real>& series, const Real& exponent) {
      return power_of_series(series, exponent, exp(exponent * log(series.each(0))), count);
    };
    const auto both = quotient ? power(product(a, b, std::min(count, a.size() + b.size() - 1)), -order)
                               : product(power(a, -order), power(b, order), count);
    return product(both, of_q, count);
  }

  // w(0) ... w(count-1), scaled such that w(0) = 1.
  [[nodiscard]] Numbers<Real> weights(std::size_t count) const {
    Numbers<Real> difference(2);
    difference.set(0, Real(1.0));
    difference.set(1, Real(-1.0));
    auto w = combine(difference, base, q, count);
    const Real scale = Real(1.0) / w.each(0);
    for (std::size_t n = 0; n < count; ++n) w.set(n, w.each(n) * scale);
    return w;
  }

  // The series of omega(exp(-t)) t^g.
  [[nodiscard]] Numbers<Real> at_one(std::size_t count) const {
    return combine(exponential_mean<Real>(count), compose_with_exponential(base, count),
                   compose_with_exponential(q, count), count);
  }
};

// The equations sum_j W(n, j) j^p = e_p(n) for all n, j < s and the s powers p, with
//   e_p(n) = Gamma(p+1)/Gamma(p+g+1) n^(p+g) / kappa - sum_{j<=n} w(n-j) j^p.
// A row of an array has one number for each power, padded to whole vectors.
template <class Real>
class WeightEquations {
 public:
  static constexpr std::size_t lanes = Real::lanes;

  // For n <= last.
  WeightEquations(const WeightTable& table, const std::vector<double>& powers, std::size_t last)
      : factors(table), exponents(powers), count(powers.size()), stride((count + lanes) / lanes * lanes) {
    exponents.push_back(table.order);
    exponents.resize(stride, 1.0);
    compute_integer_powers(std::max(last, stirling_from<Real>));
    w = factors.weights(last + 1);
    kappa = Numbers<Real>(1);
    kappa.set(0, factors.first());
    gammas = Numbers<Real>(stride);
    ratios = Numbers<Real>(stride);
    const Real one(1.0);
    for (std::size_t p = 0; p < count; p += lanes) {
      gammas.put(p, gamma(power(p) + one));
      ratios.put(p, gammas.from(p) / gamma(power(p) + factors.order + one));
    }
    compute_moments(last);
    compute_system();
  }

  [[nodiscard]] Real power(std::size_t p) const { return Real::of_doubles(&exponents[p]); }
  [[nodiscard]] std::size_t steps() const { return moments.size() / stride; }

  // Makes the first k + 1 powers exact, after the first k: one step of Gauss-Jordan elimination. The matrix
  // is totally positive, so no pivoting is needed.
  void use_power(std::size_t k) {
    const std::size_t width = 2 * stride;
    const Real scale = Real(1.0) / system.each(k * width + k);
    for (std::size_t c = 0; c < width; c += lanes)
      system.put(k * width + c, system.from(k * width + c) * scale);
    for (std::size_t r = 0; r < count; ++r) {
      if (r == k) continue;
      const Real factor = -system.each(r * width + k);
      for (std::size_t c = 0; c < width; c += lanes)
        system.put(r * width + c, system.from(r * width + c) + factor * system.from(k * width + c));
    }
  }

  // The factor of e_p in W(n, j), for the lanes from j on.
  [[nodiscard]] decltype(auto) factor(std::size_t p, std::size_t j) const {
    return system.from((2 * p + 1) * stride + j);
  }

  // Writes the weights sum_p factor(p, j) e_p with the first `used` powers from `to` on. e: one number for
  // each power from `first` on.
  void solve(const Numbers<Real>& e, std::size_t first, std::size_t used, Numbers<Real>& weights,
             std::size_t to = 0) const {
    for (std::size_t j = 0; j < used; j += lanes) {
      SumOfProducts<Real> sum;
      for (std::size_t p = 0; p < used; ++p) sum.add(factor(p, j), e.each(first + p));
      weights.put(to + j, sum.value());
    }
  }

  // max_j sum_p |factor(p, j)| (the size of the terms of e_p(n) and of sum_j W(n, j) j^p): so many units of
  // rounding W(n, j) may have as errors.
  [[nodiscard]] double size_of_terms(std::size_t n, std::size_t used, const Numbers<Real>& weights) const {
    std::vector<double> terms(used);
    for (std::size_t p = 0; p < used; ++p) {
      terms[p] = std::abs(ratios.rounded(p) / kappa.rounded(0)) * integer_powers.rounded(n * stride + p) *
                 integer_powers.rounded(n * stride + count);
      for (std::size_t j = 0; j < used; ++j)
        terms[p] += std::abs(weights.rounded(j)) * integer_powers.rounded(j * stride + p);
    }
    double largest = 0.0;
    for (std::size_t j = 0; j < used; ++j) {
      double sum = 0.0;
      for (std::size_t p = 0; p < used; ++p)
        sum += std::abs(system.rounded((2 * p + 1) * stride + j)) * terms[p];
      largest = std::max(largest, sum);
    }
    return largest;
  }

  RuleFactors<Real> factors;
  std::vector<double> exponents;           // the powers, the order of the rule, padding
  std::size_t count, stride;               // powers; numbers a row
  Numbers<Real> integer_powers;            // j^p in row j
  Numbers<Real> w, kappa, gammas, ratios;  // Gamma(p+1); Gamma(p+1) / Gamma(p+g+1)
  Numbers<Real> moments;                   // e_p(n) in row n-1
  Numbers<Real> system;  // the matrix j^p and beside it its inverse: one row a j before, a p after

 private:
  // Only powers of primes are computed; the others are products.
  void compute_integer_powers(std::size_t last) {
    integer_powers = Numbers<Real>((last + 1) * stride);
    std::vector<std::size_t> divisors(last + 1, 1);  // the least prime divisor
    std::vector<double> primes;
    for (std::size_t j = 2; j <= last; ++j) {
      if (divisors[j] != 1) continue;
      primes.push_back(static_cast<double>(j));
      for (std::size_t k = j; k <= last; k += j) divisors[k] = divisors[k] == 1 ? j : divisors[k];
    }
    const std::size_t count_of_primes = primes.size();
    primes.resize((count_of_primes + lanes - 1) / lanes * lanes, 1.0);
    Numbers<Real> logarithms(primes.size());
    for (std::size_t i = 0; i < primes.size(); i += lanes)
      logarithms.put(i, log(Real::of_doubles(&primes[i])));
    for (std::size_t i = 0; i < stride; ++i) integer_powers.set(i, Real(exponents[i] == 0.0 ? 1.0 : 0.0));
    for (std::size_t p = 0; p < stride; p += lanes) {
      integer_powers.put(stride + p, Real(1.0));
      for (std::size_t i = 0; i < count_of_primes; ++i) {
        const auto prime = static_cast<std::size_t>(primes[i]);
        integer_powers.put(prime * stride + p, exp(power(p) * logarithms.each(i)));
      }
      for (std::size_t j = 4; j <= last; ++j) {
        if (const std::size_t divisor = divisors[j]; divisor < j) {
          integer_powers.put(j * stride + p, integer_powers.from(divisor * stride + p) *
                                                 integer_powers.from(j / divisor * stride + p));
        }
      }
    }
  }

  void compute_moments(std::size_t last) {
    moments = Numbers<Real>(last * stride);
    const Real by_kappa = Real(1.0) / kappa.each(0);
    for (std::size_t n = 1; n <= last; ++n) {
      for (std::size_t p = 0; p < count; p += lanes) {
        SumOfProducts<Real> sum;
        for (std::size_t j = 0; j <= n; ++j) sum.add(integer_powers.from(j * stride + p), -w.each(n - j));
        sum.add(ratios.from(p) * by_kappa * integer_powers.each(n * stride + count),
                integer_powers.from(n * stride + p));
        moments.put((n - 1) * stride + p, sum.value());
      }
    }
  }

  void compute_system() {
    system = Numbers<Real>(2 * count * stride);
    for (std::size_t j = 0; j < count; ++j) {
      for (std::size_t p = 0; p < count; ++p) system.copy(2 * j * stride + p, integer_powers, j * stride + p);
      system.set((2 * j + 1) * stride + j, Real(1.0));
    }
  }
};

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
