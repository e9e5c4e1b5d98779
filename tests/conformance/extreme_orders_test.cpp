// SPDX-License-Identifier: MIT
// The reference at orders close to 0, 1 and 2, and its limits.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// E_g(lambda) by its power series with 120 digits in mpmath.
struct Extreme {
  double gamma, lambda, value;
};

class ExtremeOrder : public testing::TestWithParam<Extreme> {};

TEST_P(ExtremeOrder, RelaxationIsTheMittagLefflerFunction) {
  const auto [gamma, lambda, value] = GetParam();
  const reference::ReferenceValue reference =
      scene_of("relaxation", {{"gamma", gamma}, {"lambda", lambda}}).reference.at(1.0);
  EXPECT_NEAR(reference.value[0], value, reference.bound[0]);
  EXPECT_LT(reference.bound[0], 2e-16);
}

INSTANTIATE_TEST_SUITE_P(, ExtremeOrder,
                         testing::Values(Extreme{0.01, -0.5, 0.66538882063973694933},
                                         Extreme{0.99, -1.0, 0.36854831806033961629},
                                         Extreme{0.999, -1.0, 0.36794468034194146967},
                                         Extreme{1.001, -1.0, 0.36781457202796772062},
                                         Extreme{1.99, -1.0, 0.53687131303403926128},
                                         Extreme{1.999, -1.0, 0.53995886587737913656}),
                         [](const auto& test) { return std::to_string(test.index); });

// E_g(-z) = 1 - z t^g / Gamma(1+g) + ... where t^g is far from 0 at the smallest times.
TEST(ExtremeOrders, AStartLikeATwentiethPowerIsKnownAtEveryTime) {
  const reference::Reference exact = scene_of("relaxation", {{"gamma", 0.05}}).reference;
  const double small = 1e-15 / std::tgamma(1.05);
  EXPECT_NEAR(exact.at(1e-300).value[0], 1.0 - small, 2e-16);
  double series = 0.0;
  for (int k = 3; k >= 0; --k) series += std::pow(-1e-5, k) / std::tgamma(1.0 + 0.05 * k);
  EXPECT_NEAR(exact.at(1e-100).value[0], series, 2e-16);
  EXPECT_NEAR(exact.at(1e300).value[0] * std::tgamma(0.95) / 1e-15, 1.0, 2e-14);
}

// Caputo derivatives have one-sided limits: D^b u -> u - u(0) for b -> 0, D^a u -> u' - u'(0) for a -> 1.
TEST(ExtremeOrders, TheDampedOscillatorGoesWhereItsDerivativesGo) {
  constexpr double tau = 0.8, mu = 0.06, lambda = 0.1, nu = 0.1, u0 = 1.0, du0 = -0.3, t = 20.0;
  const reference::Reference limit =
      reference::linear_reference({.terms = {{1.0, 2.0}, {mu + lambda, 1.0, tau}, {1.0 + nu, 0.0}},
                                   .initial = {u0, du0},
                                   .loads = {{nu * u0 + mu * tau * du0}}},
                                  {0.0, 1.0});
  const reference::ReferenceValue at_limit = limit.at(t);
  double last = 0.0;
  for (const double off : {1e-3, 1e-4, 1e-5, 1e-6, 1e-9}) {
    const Scene scene = scene_of("damped_oscillator", {{"alpha", 1.0 + off}, {"beta", off}});
    const reference::ReferenceValue known = scene.reference.at(t);  // u, D^b u, u', D^a u
    const double distance = std::abs(known.value[0] - at_limit.value[0]);
    EXPECT_LT(distance, 5.0 * off) << off;
    EXPECT_NEAR(known.value[1], known.value[0] - u0, 5.0 * off) << off;
    EXPECT_NEAR(known.value[3], known.value[2] - du0, 5.0 * off) << off;
    EXPECT_LT(known.bound.maxCoeff(), 1e-15);
    if (last > 0.0 && off > 1e-7) {
      EXPECT_NEAR(last / distance, 10.0, 0.5) << off;
    }
    last = distance;
  }
}

// At extreme orders as at others the two methods agree with the linear reference of a small swing.
TEST(ExtremeOrders, PendulumsOfMixedOrdersSwingLikeOscillatorsWhenTheySwingLittle) {
  constexpr double small = 1e-7, t = 5.0;
  for (const auto& [alpha, beta] :
       {std::pair{1.99, 0.01}, {1.001, 0.99}, {1.01, 0.01}, {1.99, 0.99}, {1.999, 0.001}}) {
    const ParameterValues orders{{"alpha", alpha}, {"beta", beta}};
    auto swing = orders, line = orders;
    swing.insert({{"phi0", small}, {"dphi0", 0.0}});
    line.insert({{"u0", small}, {"du0", 0.0}});
    Scene scene = scene_of("pendulum", swing);
    scene.name.clear();
    scene.problem.end = t;
    const reference::ReferenceValue known = reference_of(scene).at(t),
                                    linear = scene_of("damped_oscillator", line).reference.at(t);
    for (Eigen::Index c = 0; c < known.value.size(); ++c) {
      EXPECT_NEAR(known.value[c], linear.value[c], known.bound[c] + small * small * small)
          << alpha << " " << c;
    }
    EXPECT_LT(known.bound.maxCoeff(), 1e-11 * small);
  }
}

// D^g x = y - x, D^1.5 y = -x - 4 y from x = 1, y = 1/2: x - 1 starts like -t^g/2, y - 1/2 like t^1.5. The
// powers k g are dense, and one of them represents its neighbours.
TEST(ExtremeOrders, PowersNextToEachOtherAreListedOnce) {
  for (const double gamma : {2e-9, 1e-7, 1e-6}) {
    const auto powers = scene_of("linear_system", {{"gamma1", gamma}}).smoothness.powers;
    EXPECT_EQ(powers[0].front(), gamma);
    EXPECT_EQ(powers[1].front(), 1.5);
    for (const auto& of_component : powers) {
      EXPECT_LT(of_component.size(), 10U) << gamma;
      for (std::size_t k = 1; k < of_component.size(); ++k)
        EXPECT_GE(of_component[k] - of_component[k - 1], power_separation) << gamma;
    }
  }
}

TEST(ExtremeOrders, PowersNextToEachOtherAreFewWhereCoefficientsOverflow) {
  const Scene scene = scene_of("fractional_constraint_2d", {{"alpha", 1.000000001}, {"b2", 1.7e308}});
  for (const auto& powers : scene.smoothness.powers) EXPECT_LT(powers.size(), 100U);
}

// x(0) = y(0): D^g x = y - x is 0 at t = 0, and x has no lower power than y.
TEST(ExtremeOrders, TermsNextToEachOtherThatCancelAreLeftOut) {
  const auto powers = scene_of("linear_system", {{"gamma1", 1e-7}, {"x0", 0.5}}).smoothness.powers;
  EXPECT_NEAR(powers[0].front(), 1.5, 1e-5);
  EXPECT_EQ(powers[1].front(), 1.5);
}

}  // namespace
}  // namespace fde::bench
