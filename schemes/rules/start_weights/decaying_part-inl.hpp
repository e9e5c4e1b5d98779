// SPDX-License-Identifier: MIT
// The part of the starting weights that decays exponentially. Included once for each vector target.

#if defined(FDE_DECAYING_PART_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_DECAYING_PART_INL
#undef FDE_DECAYING_PART_INL
#else
#define FDE_DECAYING_PART_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <complex>
#include <cstddef>

#include "fdebench/schemes/rules/start_weights/complex_numbers-inl.hpp"
#include "fdebench/schemes/rules/start_weights/decaying_weights.hpp"
#include "fdebench/schemes/rules/start_weights/starting_weight_equations-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// From a pair of zeros of the base outside the unit circle. With zeta = zero exp(-t) and delta the polynomial
// in omega = delta^(-g),
//   omega = t^(-g) sum_k c_k t^k,   sum_k c_k t^k = (delta / t)^(-g),
// where A_p (Expansions) is regular,
//   A_p = Gamma(p+1) (tau+t)^(-p-1) + sum_k zeta(-p-k) (-tau-t)^k / k!,   tau = -log zero.
// So -kappa e_p(n) contains 2 Re zero^(-n) n^(g-1) sum_k h_k n^(-k) / Gamma(g-k), sum_k h_k t^k = A_p sum_k
// c_k t^k.
template <class Real>
class DecayingPart {
 public:
  static constexpr std::size_t lanes = Real::lanes;
  static constexpr std::size_t terms =
      12;  // for steps from 64 on, at least 1.2 away from the singularity at t = -tau
  static constexpr std::size_t zeta_terms = 36;  // which are smaller by (|tau| / 2 pi)^k

  // zetas: zeta(-p-k) (-1)^k / k! in row k. of_start: 1 / Gamma(g-k).
  DecayingPart(const MultistepRule& rule, const WeightEquations<Real>& equations, const Numbers<Real>& zetas,
               const Numbers<Real>& of_start)
      : all_(equations), zetas_(zetas), of_start_(of_start), zero_(1), powers_(zeta_terms) {
    find_zero(rule.decay);
    powers_.set(0, Value(1.0));
    const Value tau = -log(zero_.each(0), std::log(zero_.rounded(0)));
    for (std::size_t m = 1; m < zeta_terms; ++m) powers_.set(m, powers_.each(m - 1) * tau);
  }

  [[nodiscard]] DecayingWeights weights() const {
    const Numbers<Value> terms_of_powers = expand();
    DecayingWeights made{ComplexMatrix(terms, all_.count), -std::log(zero_.rounded(0)),
                         all_.exponents[all_.count] - 1.0};
    const Real scale = Real(-2.0) / all_.kappa.each(0);
    Numbers<Value> row(all_.stride);
    for (std::size_t k = 0; k < terms; ++k) {
      for (std::size_t j = 0; j < all_.count; j += lanes) {
        SumOfProducts<Value> sum;
        for (std::size_t p = 0; p < all_.count; ++p)
          sum.add(terms_of_powers.each(k * all_.stride + p), all_.factor(p, j));
        row.put(j, sum.value() * scale);
      }
      for (std::size_t j = 0; j < all_.count; ++j)
        made.terms(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) = row.rounded(j);
    }
    return made;
  }

 private:
  using Value = Complex<Real>;

  // One step towards a zero of a polynomial.
  template <class Number, class Coefficients>
  static Number newton_step(const Number& x, std::size_t size, const Coefficients& coefficients) {
    Number value(0.0), slope(0.0);
    for (std::size_t i = size; i-- > 0;) {
      slope = slope * x + value;
      value = value * x + coefficients(i);
    }
    return x - value / slope;
  }

  // From i / decay Newton's method converges to the zero of modulus 1 / decay.
  void find_zero(double decay) {
    const auto& base = all_.factors.base;
    std::complex<double> rounded(0.0, 1.0 / decay);
    const auto rounded_base = [&](std::size_t i) HWY_ATTR { return base.rounded(i); };
    for (int step = 0; step < 7; ++step) rounded = newton_step(rounded, base.size(), rounded_base);
    Value zero(rounded);
    const auto exact_base = [&](std::size_t i) HWY_ATTR { return Value(base.each(i)); };
    for (int step = 0; step < 2; ++step) zero = newton_step(zero, base.size(), exact_base);
    zero_.set(0, zero);
  }

  // c_0, c_1, ..., from delta = (1-zeta) base(zeta).
  [[nodiscard]] Numbers<Value> series_of_omega() const {
    const auto& base = all_.factors.base;
    Numbers<Value> delta(base.size() + 1), regular(terms);
    Value power(1.0);
    for (std::size_t i = 0; i < delta.size(); ++i) {
      Real coefficient(0.0);
      if (i < base.size()) coefficient = base.each(i);
      if (i > 0) coefficient = coefficient - base.each(i - 1);
      delta.set(i, power * coefficient);
      power = power * zero_.each(0);
    }
    const auto series = compose_with_exponential(delta, terms + 1);
    for (std::size_t k = 0; k < terms; ++k) regular.set(k, series.each(k + 1));
    const Value logarithm = log(regular.each(0), std::log(regular.rounded(0)));
    const Real exponent = -all_.factors.order;
    return power_of_series(regular, Value(exponent), exp(logarithm * exponent), terms);
  }

  // h_k / Gamma(g-k) in row k.
  [[nodiscard]] Numbers<Value> expand() const {
    const Numbers<Value> c = series_of_omega();
    const Value tau = powers_.each(1), log_tau = log(tau, std::log(powers_.rounded(1)));
    Numbers<Value> h(terms * all_.stride), samples(terms * lanes);
    for (std::size_t p = 0; p < all_.count; p += lanes) {
      const Real exponent = all_.power(p) + Real(1.0);
      Value singular = exp(log_tau * -exponent) * all_.gammas.from(p);
      for (std::size_t k = 0; k < terms; ++k) {
        SumOfProducts<Value> sum;
        double binomial = 1.0;
        for (std::size_t m = k; m < zeta_terms; ++m) {
          sum.add(powers_.each(m - k) * Real(binomial), zetas_.from(m * all_.stride + p));
          binomial = binomial * static_cast<double>(m + 1) / static_cast<double>(m + 1 - k);
        }
        samples.put(k * lanes, sum.value() + singular);
        singular = singular * ((-exponent - Real(k)) / Real(k + 1)) / tau;
      }
      for (std::size_t k = 0; k < terms; ++k) {
        SumOfProducts<Value> sum;
        for (std::size_t i = 0; i <= k; ++i) sum.add(samples.from(i * lanes), c.each(k - i));
        h.put(k * all_.stride + p, sum.value() * of_start_.each(k));
      }
    }
    return h;
  }

  const WeightEquations<Real>& all_;
  const Numbers<Real>&zetas_, &of_start_;
  Numbers<Value> zero_;
  Numbers<Value> powers_;  // of tau
};

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
