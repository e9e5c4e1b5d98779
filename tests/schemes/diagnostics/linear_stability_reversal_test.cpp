// SPDX-License-Identifier: MIT
// For extremely stiff problems rules of rate 1 are more accurate than rules of rate 2: D^(1/2) y = -1e6 y,
// h = 0.01, y(1) = 5.642e-7. A rule with a weight of f_0 = lambda y_0 treats the transient, which ends before
// the first step, as an impulse, and its error is D^g of an impulse, C n^(-1-g)/Gamma(-g), for any large
// lambda.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/programs/stability/linear_multistep.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr double order = 0.5;
constexpr int reversal_steps = 100;

double exact(double rate) { return 1.0 / (-rate * std::sqrt(M_PI)); }  // to O(rate^-3)

double at_one(std::string_view scheme, double rate) {
  return solve(scheme, scalar_equation(order, rate), reversal_steps).y(0, reversal_steps);
}

double at_one(Multistep rule, double rate) {
  return multistep_relaxation(rule, order, rate * 0.1, reversal_steps)[reversal_steps];
}

TEST(Reversal, FirstOrderRulesAreRight) {
  for (const auto* scheme : {"l1", "grunwald_letnikov"}) {
    for (const double rate : {-1e4, -1e6, -1e8})
      EXPECT_NEAR(at_one(scheme, rate) / exact(rate), 1.0, 0.01) << scheme << rate;
  }
}

TEST(Reversal, SecondOrderRulesAreWrongBy23To8460Times) {
  const double reference = exact(-1e6);
  EXPECT_NEAR(at_one("product_trapezoidal", -1e6), -6.6e-5, 1e-6);
  EXPECT_NEAR(at_one(Multistep::bdf2, -1e6), 6.5e-5, 1e-6);
  EXPECT_NEAR(at_one(Multistep::newton_gregory, -1e6), 1.4e-5, 1e-6);
  EXPECT_NEAR(at_one(Multistep::trapezoidal, -1e6), 4.8e-3, 1e-4);
  const auto error = [&](double value) { return std::abs(value / reference - 1.0); };
  EXPECT_NEAR(error(at_one(Multistep::newton_gregory, -1e6)), 23.1, 0.1);
  EXPECT_NEAR(error(at_one(Multistep::bdf2, -1e6)), 115.0, 0.1);
  EXPECT_NEAR(error(at_one("product_trapezoidal", -1e6)), 117.6, 0.1);
  EXPECT_NEAR(error(at_one(Multistep::trapezoidal, -1e6)), 8460.0, 5.0);
}

TEST(Reversal, WhatIsWrongDoesNotKnowTheRate) {
  EXPECT_NEAR(at_one("product_trapezoidal", -1e10) / at_one("product_trapezoidal", -1e8), 1.0, 0.01);
  for (const auto rule : {Multistep::bdf2, Multistep::newton_gregory, Multistep::trapezoidal})
    EXPECT_NEAR(at_one(rule, -1e10) / at_one(rule, -1e8), 1.0, 0.01);
}

// y_n ~ C n^(-3/2) where the generating function has no zero on the unit circle; the trapezoidal multistep
// rule has one at zeta = -1, and y_n oscillates like (-1)^n n^(-1/2).
TEST(Reversal, TheImpulseDecaysLikeItsFractionalDerivative) {
  const auto slope = [](Multistep rule) {
    const Vec y = multistep_relaxation(rule, order, -1e15, 2000);
    return std::log2(std::abs(y[2000] / y[1000]));
  };
  EXPECT_NEAR(slope(Multistep::bdf2), -1.5, 0.02);
  EXPECT_NEAR(slope(Multistep::newton_gregory), -1.5, 0.02);
  EXPECT_NEAR(slope(Multistep::trapezoidal), -0.5, 0.02);
  const Vec y = multistep_relaxation(Multistep::trapezoidal, order, -1e15, 2000);
  EXPECT_LT(y[1999] * y[2000], 0.0);
}

// These rules have rate 2 where the step size resolves the transient.
TEST(Reversal, SecondOrderRulesWinWhereTheyResolveTheTransient) {
  const double reference = 0.427583576155807;
  for (const auto rule : {Multistep::bdf2, Multistep::newton_gregory, Multistep::trapezoidal}) {
    const double error = std::abs(multistep_relaxation(rule, order, -0.1, 100)[100] - reference);
    const double halved =
        std::abs(multistep_relaxation(rule, order, -std::sqrt(1.0 / 200), 200)[200] - reference);
    EXPECT_NEAR(std::log2(error / halved), 2.0, 0.25);
    EXPECT_LT(error, 1e-2 * std::abs(at_one("l1", -1.0) - reference));
  }
}

}  // namespace
}  // namespace fde::bench
