// SPDX-License-Identifier: MIT
// Linear stability regions compared with the exact sector |arg z| > g pi/2.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdebench/schemes/diagnostics/stability_region.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

const Scheme& scheme(std::string_view id) { return *find_scheme(id); }

void expect_sector(std::string_view id, const std::vector<double>& orders, double tolerance = 1e-12) {
  for (const double order : orders) {
    EXPECT_EQ(real_stability_interval(scheme(id), order), infinity) << id << order;
    EXPECT_NEAR(stability_angle(scheme(id), order), pi - 0.5 * order * pi, tolerance) << id << order;
  }
}

// Up to order 1: Lubich, IMA J. Numer. Anal. 6 (1986); see docs/stability.md, section 7. L2-1_sigma up to the
// rounding of Lerch's function. Above: |arg (1 - zeta)^g| <= g pi/2; L1 is the product of order 1 and L1 of
// order g - 1.
TEST(StabilityRegion, HoldsTheSectorOfTheEquation) {
  const std::vector<double> up_to_one{0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0};
  for (const auto* id : {"l1", "grunwald_letnikov", "product_trapezoidal"}) expect_sector(id, up_to_one);
  expect_sector("l2_1_sigma", up_to_one, 1e-7);
  for (const auto* id : {"l1", "grunwald_letnikov"}) expect_sector(id, {1.01, 1.1, 1.5, 1.9, 1.99});
}

// L1-2 is not: the angles, in degrees, are the minima of |arg(-z)| on the boundary, from polylogarithms in 20
// digits by mpmath.
TEST(StabilityRegion, OfL1TwoMissesTheSectorByHalfADegree) {
  for (const auto& [order, degrees] : {std::pair{0.1, 170.649808},
                                       {0.3, 152.431723},
                                       {0.5, 134.579150},
                                       {0.8, 107.932229},
                                       {0.9, 98.988016}}) {
    EXPECT_EQ(real_stability_interval(scheme("l1_2"), order), infinity) << order;
    EXPECT_NEAR(stability_angle(scheme("l1_2"), order), degrees * pi / 180.0, 1e-5) << order;
  }
  EXPECT_NEAR(stability_angle(scheme("l1_2"), 1.0), pi / 2.0, 1e-7);
}

// Dirichlet's eta function, by Euler's transformation.
double eta(double s) {
  double sum = 0.0;
  for (int n = 0; n < 60; ++n) {
    double binomial = 1.0, inner = 0.0;
    for (int k = 0; k <= n; ++k) {
      inner += (k % 2 == 0 ? 1.0 : -1.0) * binomial * std::pow(k + 1.0, -s);
      binomial *= (n - k) / (k + 1.0);
    }
    sum += std::ldexp(inner, -n - 1);
    if (std::abs(std::ldexp(inner, -n - 1)) < 1e-15) break;
  }
  return sum;
}

// W(-1) = 4 eta(-g-1) changes its sign at g = 1.
TEST(StabilityRegion, OfTheTrapezoidalRuleIsFiniteAboveOrderOne) {
  for (const double order : {1.01, 1.1, 1.3, 1.5, 1.7, 1.9, 1.99}) {
    const double end = std::tgamma(order + 2.0) / (-4.0 * eta(-order - 1.0));
    EXPECT_NEAR(real_stability_interval(scheme("product_trapezoidal"), order) / end, 1.0, 1e-10) << order;
    EXPECT_EQ(stability_angle(scheme("product_trapezoidal"), order), 0.0);
  }
}

// A mode is at zeta = 1 where the corrector cancels the predictor, 1 + z / Gamma(g+2) = 0.
TEST(StabilityRegion, OfPredictCorrectEndsWhereTheCorrectionUndoesThePrediction) {
  for (const double order : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0, 1.1, 1.3, 1.5}) {
    EXPECT_NEAR(real_stability_interval(scheme("adams_pc"), order), std::tgamma(order + 2.0), 1e-9) << order;
  }
}

// Near order 1 the boundary curve of the chain crosses the real axis near zeta = -1, at pi - theta = 0.015
// for order 1.0001. The expected ends are from an independent tracking of the roots.
TEST(StabilityRegion, OfTheChainIsContinuousAtOrderOne) {
  const Scheme& chain = *find_scheme("decoupled_multi_order");
  for (const auto& [order, end] : {std::pair{1.0001, 1.999934}, {1.001, 1.999344}, {1.0018, 1.998821}}) {
    EXPECT_NEAR(real_stability_interval(chain, order), end, 1e-6) << order;
    EXPECT_EQ(stability_angle(chain, order), 0.0) << order;
  }
  EXPECT_NEAR(real_stability_interval(chain, 1.0 + 1e-7), 2.0, 1e-6);
}

// From about order 1.7 on the interval ends at zeta = -1, with eta values as above.
TEST(StabilityRegion, OfPredictCorrectNearOrderTwoEndsAtMinusOne) {
  for (const double order : {1.75, 1.8, 1.9, 1.99}) {
    const double k = 1.0 / std::tgamma(order + 2.0),
                 predictor = -2.0 * eta(-order) / std::tgamma(order + 1.0);
    const double known = k * (4.0 * eta(-order - 1.0) - 1.0);
    const double x = real_stability_interval(scheme("adams_pc"), order);
    EXPECT_NEAR(1.0 + known * x - k * predictor * x * x, 0.0, 1e-10) << order;
    EXPECT_LT(x, std::tgamma(order + 2.0));
  }
}

TEST(StabilityRegion, AtOrderOneIsTheClassicalOne) {
  EXPECT_NEAR(real_stability_interval(scheme("adams_pc"), 1.0), 2.0, 1e-10);  // Heun's method
  EXPECT_TRUE(is_linearly_stable(scheme("adams_pc"), scalar_equation(1.0, {-1.0, 1.7}), 1.0));
  EXPECT_FALSE(is_linearly_stable(scheme("adams_pc"), scalar_equation(1.0, {-1.0, 1.8}),
                                  1.0));  // |1 + z + z^2/2| = 1: 1.732
  EXPECT_TRUE(
      is_linearly_stable(scheme("l1"), scalar_equation(1.0, {2.1, 0.0}), 1.0));  // outside the disc about 1
  EXPECT_FALSE(is_linearly_stable(scheme("l1"), scalar_equation(1.0, {1.9, 0.0}), 1.0));
  EXPECT_EQ(count_growing_modes(scheme("product_trapezoidal"), scalar_equation(1.0, {0.5, 3.0}), 1.0), 2);
}

// The number of growing modes changes across the boundary, at angles where both roots z are simple. The
// displacement is not along z, because the boundary of the fractional trapezoidal rule is a ray.
TEST(StabilityRegion, CountChangesAcrossTheBoundary) {
  for (const auto* one : schemes_with_symbol()) {
    for (const double order : {0.3, 0.8, 1.4}) {
      for (const double theta : {0.3, 1.0, 2.0}) {
        for (const ComplexValue z : root_locus(*one, order, theta)) {
          const auto count = [&](ComplexValue factor) {
            return count_growing_modes(*one, test_problem(*one, order, factor * z), 1.0).value();
          };
          EXPECT_EQ(std::abs(count({1.0 - 1e-6, -1e-6}) - count({1.0 + 1e-6, 1e-6})), 2)
              << one->id << order << ' ' << theta;
        }
      }
    }
  }
}

// A(alpha)-stability of the classical formulas: Hairer & Wanner, Solving Ordinary Differential Equations II,
// V.2, table 2.1. Because |arg delta(zeta)^g| <= g (pi - alpha), order g < 1 is stable for
// |arg(-z)| < pi - g (pi - alpha).
TEST(StabilityRegion, OfTheFormulasOfBackwardDifferencesHasTheAnglesOfTheClassicalOnes) {
  constexpr double degree = pi / 180.0;
  for (const auto& [id, alpha] :
       {std::pair{"bdf2", 90.0}, {"bdf3", 86.03}, {"bdf4", 73.35}, {"bdf5", 51.84}, {"bdf6", 17.84}}) {
    for (const double order : {0.2, 0.5, 0.8, 1.0}) {
      EXPECT_EQ(real_stability_interval(scheme(id), order), infinity) << id << order;
      EXPECT_NEAR(stability_angle(scheme(id), order), pi - order * (pi - alpha * degree), 1e-3)
          << id << order;
    }
  }
}

// omega = ((1+zeta)/(1-zeta)/2)^g maps the disc onto the sector |arg| < g pi/2.
TEST(StabilityRegion, OfTheFractionalTrapezoidalRuleIsTheSectorOfTheEquation) {
  const Scheme& rule = scheme("fractional_trapezoidal");
  for (const double order : {0.1, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9}) {
    EXPECT_NEAR(stability_angle(rule, order), pi - 0.5 * order * pi, 1e-12) << order;
    for (const double size : {0.5, 1.0, 2.0}) {
      const auto stable_at = [&](double arg) {
        return is_linearly_stable(rule, scalar_equation(order, std::polar(size, arg)), 1.0);
      };
      EXPECT_TRUE(stable_at(0.5 * order * pi + 1e-6)) << order << ' ' << size;
      EXPECT_FALSE(stable_at(0.5 * order * pi - 1e-6)) << order << ' ' << size;
    }
  }
}

TEST(StabilityRegion, StepAndRateEnterAsOneNumber) {
  for (const auto* one : schemes_with_symbol()) {
    const double order = 1.5, x = real_stability_interval(scheme("adams_pc"), order);
    for (const double h : {1e-3, 7.0}) {
      const Problem problem = test_problem(*one, order, -1.2 * x * std::pow(h, -order));
      EXPECT_EQ(count_growing_modes(*one, problem, h),
                count_growing_modes(*one, test_problem(*one, order, -1.2 * x), 1.0));
    }
  }
}

// The trapezoidal rule has a weight of f_0 at every step: from R = -S/W,
//   y_n / y_0 -> zeta(-g) sin(pi g)/pi n^(-1-g);  zeta(-1/2) = -0.2078862249773545.
TEST(ResponseAtInfinity, OfTheTrapezoidalRuleDecaysSlowly) {
  const Vec y = stiff_limit(scheme("product_trapezoidal"), 0.5, 4000).value();
  EXPECT_NEAR(y[1], -0.5, 1e-14);
  EXPECT_NEAR(y[4000] * std::pow(4000.0, 1.5), -0.2078862249773545 / pi, 1e-4);
  EXPECT_NEAR(stiff_limit(scheme("product_trapezoidal"), 1.0, 9).value()[9], -1.0, 1e-14);
  EXPECT_GT(std::abs(stiff_limit(scheme("product_trapezoidal"), 1.2, 10).value()[10]), 20.0);
}

TEST(ResponseAtInfinity, OfTheFirstOrderRulesIsZero) {
  for (const auto* id : {"l1", "grunwald_letnikov"}) {
    for (const double order : {0.1, 0.9, 1.5})
      EXPECT_EQ(stiff_limit(scheme(id), order, 10)->tail(10).cwiseAbs().maxCoeff(), 0.0) << id;
  }
  EXPECT_FALSE(stiff_limit(scheme("adams_pc"), 0.5, 3).has_value());
}

TEST(GrowingModes, RefusesWhatHasNoSymbol) {
  const auto& l1 = scheme("l1");
  expect_message([&] { count_growing_modes(l1, scene_of("brusselator").problem, 0.1); }, "no linear part");
  expect_message(
      [&] {
        count_growing_modes(l1, scene_of("fractional_constraint_2d", {{"formulation", "multiplier"}}).problem,
                            0.1);
      },
      "linear stability of l1");
  expect_message(
      [&] { is_linearly_stable(scheme("commensurate_adams_pc"), scalar_equation(0.987654321, -1.0), 1.0); },
      "multiples of one 1/M");
  expect_message([&] { real_stability_interval(l1, 2.5); }, "takes orders in");
}

}  // namespace
}  // namespace fde::bench
