// SPDX-License-Identifier: MIT
// The undamped pendulum in closed form: first integral, equation, limits, and its own digits.

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>

#include "support/testing.hpp"

namespace fde::reference {
namespace {

bench::Scene free_pendulum(double g, double phi0, double dphi0) {
  return bench::scene_of(
      "pendulum",
      {{"mu", 0.0}, {"nu", 0.0}, {"lambda", 0.0}, {"g_over_L", g}, {"phi0", phi0}, {"dphi0", dphi0}});
}

struct Start {
  double g, phi0, dphi0;
};
// Libration, rotation in both directions, inverted pendulums, starts beyond one turn, near the top and on the
// separatrix.
const std::vector<Start> starts{{1.0, 1.0, -0.3},   {1.0, 1.0, -3.0}, {-2.0, 10.0, 3.0}, {-2.0, 10.0, 1.0},
                                {9.81, 3.0, 0.0},   {0.5, -7.0, 0.1}, {1.0, 0.0, 2.0},   {1.0, 0.0, -2.0},
                                {1.0, 3.141, 1e-4}, {0.0, 1.0, -0.3}, {1e-3, 2.0, 1e3},  {1e6, 1e-3, 0.0}};

class FreePendulum : public testing::TestWithParam<Start> {
 protected:
  const bench::Scene scene_ = free_pendulum(GetParam().g, GetParam().phi0, GetParam().dphi0);
};

TEST_P(FreePendulum, StartsWhereItIsPut) {
  const ReferenceValue known = scene_.reference.at(0.0);
  EXPECT_NEAR(known.value[0], GetParam().phi0, known.bound[0]);
  EXPECT_NEAR(known.value[1], GetParam().dphi0, known.bound[1]);
}

TEST_P(FreePendulum, KeepsItsEnergyToTheBound) {
  const auto [g, phi0, dphi0] = GetParam();
  const double start = scene_.energy.value(scene_.reference.at(0.0).value);
  for (const double t : {0.3, 1.0, 17.0, 1e3, 1e5}) {
    const ReferenceValue known = scene_.reference.at(t);
    const double phi = known.value[0], dphi = known.value[1];
    const double allowed = std::abs(dphi) * known.bound[1] + std::abs(g * std::sin(phi)) * known.bound[0];
    EXPECT_NEAR(scene_.energy.value(known.value), start, allowed + 1e-14 * (std::abs(start) + std::abs(g)))
        << t;
  }
}

// phi' and phi'' by central differences of rate 4.
TEST_P(FreePendulum, SolvesItsEquation) {
  const auto [g, phi0, dphi0] = GetParam();
  const double pace = std::sqrt(std::abs(g)) + std::abs(dphi0) + 0.1;
  for (const double turns : {0.5, 2.0, 11.0}) {
    const double t = turns / pace, h = 1e-3 / pace;
    const auto column = [&](double at, int c) { return scene_.reference.at(at).value[c]; };
    const auto slope = [&](int c) {
      return (8.0 * (column(t + h, c) - column(t - h, c)) - (column(t + 2 * h, c) - column(t - 2 * h, c))) /
             (12.0 * h);
    };
    EXPECT_NEAR(slope(0), column(t, 1), 1e-10 * pace) << t;
    EXPECT_NEAR(slope(1), -g * std::sin(column(t, 0)), 1e-10 * pace * pace) << t;
  }
}

// at() takes doubles and digits() decimals: the tolerance is 1 unit in the last place of each, amplified by
// the phase.
TEST_P(FreePendulum, IsWhatItIsInDigits) {
  const auto [g, phi0, dphi0] = GetParam();
  for (const double t : {0.3, 17.0, 1e5}) {
    const ReferenceValue known = scene_.reference.at(t);
    const auto digits = scene_.reference.digits(t, 30);
    const double phase = (std::sqrt(std::abs(g)) + std::abs(dphi0)) * t + std::abs(phi0) + 1.0;
    for (int c = 0; c < 2; ++c) {
      const double scale = c == 0 ? 1.0 : std::sqrt(std::abs(g)) + std::abs(dphi0);
      EXPECT_NEAR(known.value[c], std::stod(digits[static_cast<std::size_t>(c)].value),
                  known.bound[c] + 1e-14 * phase * scale)
          << t;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, FreePendulum, testing::ValuesIn(starts),
                         [](const auto& test) { return std::to_string(test.index); });

// sin(phi/2) = k sn(t + K, k) from rest at phi0, with k = sin(phi0/2), by Boost's functions.
TEST(FreePendulumAgainstBoost, SwingsFromRest) {
  const double phi0 = 2.0, k = std::sin(phi0 / 2);
  const Reference exact = free_pendulum(1.0, phi0, 0.0).reference;
  for (const double t : {0.1, 1.0, 10.0, 100.0}) {
    const double sn = boost::math::jacobi_sn(k, t + boost::math::ellint_1(k));
    EXPECT_NEAR(std::sin(exact.at(t).value[0] / 2), k * sn, 1e-13) << t;
  }
}

// The period is 4 K(k): after 15,000 periods the state is the initial state.
TEST(FreePendulumAgainstBoost, HasItsPeriodForALongTime) {
  const double phi0 = 2.0;
  const long double period = 4.0L * boost::math::ellint_1(std::sin(1.0L));
  const auto t = static_cast<double>(15000.0L * period);
  const ReferenceValue known = free_pendulum(1.0, phi0, 0.0).reference.at(t);
  EXPECT_GT(t, 1e5);
  EXPECT_NEAR(known.value[0], phi0, 1e-11);
  EXPECT_NEAR(known.value[1], 0.0, 2e-11);  // from half a unit in the last place of t
  EXPECT_LT(known.bound.maxCoeff(), 1e-9);
}

// The double nearest to pi is pi - d, d = 1.2246467991473515e-16: near the top, phi = pi - d cosh t.
TEST(FreePendulumAtItsTop, FallsFromTheDoubleAndNotFromPi) {
  constexpr double d = 1.2246467991473515e-16;
  const Reference exact = free_pendulum(1.0, std::numbers::pi, 0.0).reference;
  for (const double t : {1.0, 10.0, 20.0}) {
    EXPECT_NEAR(exact.at(t).value[1], -d * std::sinh(t), 1e-14 * d * std::sinh(t)) << t;
  }
  const ReferenceValue fallen = exact.at(36.0);
  EXPECT_NEAR(fallen.value[0], 2.8779881298370611, 1e-14);  // mpmath, 50 digits
  EXPECT_LT(fallen.bound.maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace fde::reference
