// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/polylogarithm.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace fde {

namespace {

// (exp(s to) - exp(s from)) / s, also at its limit s = 0.
ComplexValue power_difference(double s, ComplexValue from, ComplexValue to) {
  if (s == 0.0) return to - from;
  return std::exp(s * from) * exp_minus_one(s * (to - from)) / s;
}

// sum over |k| >= first of (2 pi i k - mu)^(s-1), s <= 0, by the Euler-Maclaurin formula. Both signs of k are
// summed together, because the sum over one sign diverges for s = 0.
ComplexValue tail(double s, ComplexValue mu, int first) {
  constexpr std::array<double, 9> coefficients{1.0 / 12,
                                               -1.0 / 720,
                                               1.0 / 30240,
                                               -1.0 / 1209600,
                                               1.0 / 47900160,
                                               -691.0 / 1307674368000,
                                               1.0 / 74724249600,
                                               -3617.0 / 10670622842880000.0,
                                               43867.0 / 5109094217170944000.0};
  const ComplexValue turn{0.0, 2.0 * std::numbers::pi};
  const ComplexValue above = static_cast<double>(first) * turn - mu,
                     below = -static_cast<double>(first) * turn - mu;
  ComplexValue sum = power_difference(s, std::log(above), std::log(below)) / turn;
  for (const auto& [base, step] : {std::pair{above, turn}, {below, -turn}}) {
    const ComplexValue value = std::pow(base, s - 1.0), ratio = step / base;
    ComplexValue derivative = value * (s - 1.0) * ratio;  // of order 2j - 1
    sum += 0.5 * value;
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
      sum -= coefficients[j] * derivative;
      const double m = 2.0 * static_cast<double>(j) + 2.0;
      derivative *= (s - m) * (s - m - 1.0) * ratio * ratio;
    }
  }
  return sum;
}

using Real = long double;

constexpr int terms = 64;  // |mu| / (2 pi) is at most 0.513

// The Euler-Maclaurin formula from k = 8 on, where it is accurate to 1e-17.
Real by_sum(Real p, Real a) {
  constexpr int first = 8;
  constexpr std::array<Real, 12> bernoulli{
      1.0L / 6, -1.0L / 30,     1.0L / 42,      -1.0L / 30,       5.0L / 66,       -691.0L / 2730,
      7.0L / 6, -3617.0L / 510, 43867.0L / 798, -174611.0L / 330, 854513.0L / 138, -236364091.0L / 2730};
  Real sum = 0;
  for (int k = 0; k < first; ++k) sum += std::pow(k + a, p);
  const Real x = first + a;
  sum += std::pow(x, p) / 2 - std::pow(x, p + 1) / (p + 1);
  Real derivative = p * std::pow(x, p - 1);  // of order 2j - 1, over (2j)!
  Real factorial = 2;
  for (std::size_t j = 0; j < bernoulli.size(); ++j) {
    sum -= bernoulli[j] / factorial * derivative;
    const Real m = 2 * static_cast<Real>(j) + 1;
    derivative *= (p - m) * (p - m - 1) / (x * x);
    factorial *= (m + 2) * (m + 3);
  }
  return sum;
}

// Hurwitz's formula: 2 Gamma(p+1) (2 pi)^(-p-1) sum_{n>=1} sin(2 pi n a - pi p / 2) / n^(p+1).
Real by_fourier_series(Real p, Real a) {
  constexpr Real pi = std::numbers::pi_v<Real>;
  Real sum = 0;
  for (int n = 1;; ++n) {
    const Real size = std::pow(static_cast<Real>(n), -p - 1);
    if (size < 1e-20L) break;
    sum += size * std::sin(2 * pi * std::fmod(n * a, 1.0L) - pi * std::fmod(p / 2, 2.0L));
  }
  return 2 * std::tgamma(p + 1) * std::pow(2 * pi, -p - 1) * sum;
}

}  // namespace

ComplexValue exp_minus_one(ComplexValue z) {
  const double x = z.real(), y = z.imag(), half = std::sin(0.5 * y);
  return {std::expm1(x) * std::cos(y) - 2.0 * half * half, std::exp(x) * std::sin(y)};
}

// Li_s(e^mu) = Gamma(1-s) sum_{k in Z} (2 pi i k - mu)^(s-1)    (Lindelof; Bateman, vol. 1, 1.11 (16)).
ComplexValue scaled_polylogarithm(double s, ComplexValue mu) {
  constexpr int terms = 10;
  constexpr double negligible = 1e-18;  // the sum is at most 1
  const ComplexValue power = std::pow(-mu, 1.0 - s);
  ComplexValue sum = 0.0;
  if (std::abs(power) > negligible) {
    sum = tail(s, mu, terms);
    for (int k = terms - 1; k > 0; --k) {
      const ComplexValue shift{0.0, 2.0 * std::numbers::pi * k};
      sum += std::pow(shift - mu, s - 1.0) + std::pow(-shift - mu, s - 1.0);
    }
  }
  return std::tgamma(1.0 - s) * (1.0 + power * sum);
}

long double hurwitz_zeta_at_minus(long double p, long double a) {
  return p < 6 ? by_sum(p, a) : by_fourier_series(p, a);
}

Lerch::Lerch(double s, double a) : s_(s), a_(a) {
  Real factorial = 1;
  for (int k = 0; k < terms; ++k) {
    coefficients_.push_back(static_cast<double>(hurwitz_zeta_at_minus(k - Real{s}, a) / factorial));
    factorial *= k + 1;
  }
}

ComplexValue Lerch::scaled(ComplexValue mu) const {
  ComplexValue sum = 0.0;
  for (std::size_t k = coefficients_.size(); k-- > 0;) sum = sum * mu + coefficients_[k];
  return std::exp(-a_ * mu) * (std::tgamma(1.0 - s_) + std::pow(-mu, 1.0 - s_) * sum);
}

}  // namespace fde
