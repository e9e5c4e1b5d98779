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

}  // namespace fde
