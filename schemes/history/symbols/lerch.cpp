// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/lerch.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace fde {
namespace {

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
