// SPDX-License-Identifier: MIT
// Tarasov & Zaslavsky 2006, the calculus: eqs 22-28, as printed and corrected.

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "support/caputo.hpp"

namespace fde::bench {
namespace {

// f = (1 - s)^3 at t = 0.3, order 1/2, from the right end 1: by the power rule and by quadrature.
TEST(ErrataTarasov, Equation22LacksTheSignAndTurnsTheKernel) {
  const double t = 0.3, order = 0.5;
  const auto slope = [](double s) { return -3.0 * (1.0 - s) * (1.0 - s); };
  const double exact = caputo_derivative_of_power(3.0, order, 1.0 - t);
  EXPECT_NEAR(exact, 0.740150679203982, 1e-14);
  EXPECT_NEAR(right_caputo(slope, order, t, 1.0), exact, 1e-12);
  // As printed (t - s)^(-1/2) with t < s, without (-1)^m: an imaginary number.
  const double size = integral(slope, t, 1.0, -order) * reference::reciprocal_gamma(1.0 - order);
  const std::complex<double> printed = std::pow(std::complex<double>(-1.0), -order) * size;
  EXPECT_NEAR(printed.real(), 0.0, 1e-12);
  EXPECT_NEAR(printed.imag(), exact, 1e-12);
  // With only the kernel corrected, the sign is still wrong.
  EXPECT_NEAR(size, -exact, 1e-12);
}

// f = t^2 = 1 + 2 x + x^2 with x = t - a from a = 1: d/dt D^(1/2) f = D^(3/2) f + boundary term.
TEST(ErrataTarasov, Equation23HoldsOnlyForDerivativesFromZero) {
  const double a = 1.0, t = 2.0, x = t - a, order = 0.5, slope_at_a = 2.0;
  const double left = 2.0 * (1.0 - order) * caputo_derivative_of_power(1.0, order, x) / x +
                      (2.0 - order) * caputo_derivative_of_power(2.0, order, x) / x;
  EXPECT_NEAR(left, 3.38513750128654, 1e-13);
  const double higher = fractional_integral([](double) { return 2.0; }, 1.0 - order, x);  // D^(3/2) f
  EXPECT_NEAR(higher + slope_at_a * std::pow(t - a, -order) / reference::gamma(1.0 - order), left, 1e-12);
  const double printed = higher + slope_at_a * std::pow(t, -order) / reference::gamma(1.0 - order);
  EXPECT_NEAR(printed, 3.05464289499389, 1e-12);
  EXPECT_NEAR(left - printed, 2.0 * (1.0 - 1.0 / std::sqrt(2.0)) / std::sqrt(std::numbers::pi), 1e-12);
}

// d/dt J^e f = J^e f' + boundary term for f = t^2, e = 0.3, between a = 1 and t = 2.
TEST(ErrataTarasov, Equation26HoldsOnlyForIntegralsFromZero) {
  const double a = 1.0, t = 2.0, x = t - a, order = 0.3, value_at_a = 1.0;
  const double left = value_at_a * std::pow(x, order - 1.0) / reference::gamma(order) +
                      2.0 * caputo_derivative_of_power(1.0, 1.0 - order, x) +
                      caputo_derivative_of_power(2.0, 1.0 - order, x);
  const double inner = fractional_integral([&](double s) { return 2.0 * (a + s); }, order, x);
  EXPECT_NEAR(inner + value_at_a * std::pow(t - a, order - 1.0) / reference::gamma(order), left, 1e-12);
  EXPECT_GT(left - (inner + value_at_a * std::pow(t, order - 1.0) / reference::gamma(order)), 0.1);
}

// (43) inherits the error of (23): D^(a+1) q lacks the same power of t - a.
TEST(ErrataTarasov, Equation43TakesThePowerOfTOver) {
  const double a = 0.5, t = 1.7, x = t - a, order = 1.4, second_at_a = 2.0;
  // q = x^2: D^1.4 q is a power, its derivative follows by the power rule, D^2.4 q = J^0.6 q''' = 0.
  const double left = (2.0 - order) * caputo_derivative_of_power(2.0, order, x) / x;
  EXPECT_EQ(caputo_derivative_of_power(2.0, order + 1.0, x), 0.0);
  EXPECT_NEAR(second_at_a * std::pow(t - a, 1.0 - order) / reference::gamma(2.0 - order), left, 1e-14);
  EXPECT_GT(std::abs(second_at_a * std::pow(t, 1.0 - order) / reference::gamma(2.0 - order) - left), 0.1);
}

}  // namespace
}  // namespace fde::bench
