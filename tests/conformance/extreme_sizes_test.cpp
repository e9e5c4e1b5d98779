// SPDX-License-Identifier: MIT
// The reference of scenes with huge and tiny values, decay rates and times, and scenes without a reference.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

reference::ReferenceValue exact_at(std::string_view scene, const ParameterValues& values, double t) {
  return scene_of(scene, values).reference.at(t);
}

// Linear scenes without load: the solution is proportional to its initial value.
TEST(ExtremeSizes, LinearScenesScale) {
  for (const double size : {1e150, 1e-150, 1e300, 1e-290}) {
    const reference::ReferenceValue one = exact_at("relaxation", {}, 0.5),
                                    scaled = exact_at("relaxation", {{"y0", size}}, 0.5);
    EXPECT_NEAR(scaled.value[0] / size, one.value[0], 1e-15) << size;
    EXPECT_LT(scaled.bound[0], 1e-15 * size);
    const reference::ReferenceValue swing = exact_at("damped_oscillator", {}, 20.0);
    const reference::ReferenceValue large =
        exact_at("damped_oscillator", {{"u0", size}, {"du0", -0.3 * size}}, 20.0);
    for (Eigen::Index c = 0; c < swing.value.size(); ++c) {
      EXPECT_NEAR(large.value[c] / size, swing.value[c], 2e-15) << size;
      EXPECT_LT(large.bound[c], 1e-15 * size);
    }
  }
}

// y = t^-g / (-lambda Gamma(1-g)) for a huge rate, 1 + lambda t^g / Gamma(1+g) for a tiny one.
TEST(ExtremeSizes, RatesMayBeHugeAndTiny) {
  const double root = std::sqrt(std::acos(-1.0));
  for (const double rate : {1e100, 1e150, 1e300}) {
    const reference::ReferenceValue known = exact_at("stiff_relaxation", {{"lambda", -rate}}, 1.0);
    EXPECT_NEAR(known.value[0] * rate * root, 1.0, 1e-15) << rate;
    EXPECT_NEAR(exact_at("relaxation", {{"lambda", -1.0 / rate}}, 1.0).value[0], 1.0, 1e-16) << rate;
  }
}

// A pendulum of mass 1 that swings by 1e-150 is the linear one.
TEST(ExtremeSizes, ATinySwingHasRelativeAccuracy) {
  Scene scene = scene_of("pendulum", {{"phi0", 1e-150}, {"dphi0", 0.0}});
  scene.name.clear();
  scene.problem.end = 5.0;
  const reference::ReferenceValue known = reference_of(scene).at(5.0);
  const reference::ReferenceValue linear = exact_at("damped_oscillator", {{"u0", 1.0}, {"du0", 0.0}}, 5.0);
  for (Eigen::Index c = 0; c < known.value.size(); ++c) {
    EXPECT_NEAR(known.value[c] / 1e-150, linear.value[c], 1e-13) << c;
  }
  EXPECT_LT(known.bound.maxCoeff(), 1e-163);
}

// u = cos t - 0.3 sin t at t = 1e5 with 40 digits in mpmath.
TEST(ExtremeTimes, TheOscillatorKeepsItsPhase) {
  const ParameterValues free{{"mu", 0.0}, {"lambda", 0.0}, {"nu", 0.0}};
  const reference::ReferenceValue known = exact_at("damped_oscillator", free, 1e5);
  EXPECT_NEAR(known.value[0], -1.0100854468298174047, known.bound[0]);
  EXPECT_LT(known.bound.maxCoeff(), 1e-12);
}

// u ~ (nu tau^(1/2) u(0) + mu tau^(3/2) u'(0)) / sqrt(pi t) for large t: the spring balances the memory of
// u(0) in D^(1/2) u and of u'(0) in D^(3/2) u.
TEST(ExtremeTimes, TheDampedOscillatorEndsInItsMemory) {
  const double coefficient = (0.1 - 0.06 * 0.8 * 0.3) * std::sqrt(0.8 / std::acos(-1.0));
  for (const double t : {1e5, 1e10, 1e100, 1e250}) {
    const reference::ReferenceValue known = exact_at("damped_oscillator", {}, t);
    EXPECT_NEAR(known.value[0] * std::sqrt(t) / coefficient, 1.0, 0.4 / t + 1e-14) << t;
  }
}

// A mass above its point of suspension falls through it: r = 0.
TEST(Singularities, AReferenceEndsThereAndSaysSo) {
  Scene scene = scene_of("extensible_pendulum", {{"dxi0", -3.0}, {"phi0", 0.0}});
  scene.name.clear();
  expect_message([&] { reference_of(scene); }, "singularity, r = L (1 + xi) = 0, at t = 0.37");
}

TEST(Singularities, ASphereEndsAtItsPoles) {
  const Scene scene = scene_of("loxodrome", {{"speed", 1.0}});
  const Vec inside = taylor_part(scene.problem, 0.0);
  Vec outside = inside;
  outside[0] = -0.1;
  EXPECT_TRUE(scene.problem.domain.contains(0.0, inside));
  EXPECT_FALSE(scene.problem.domain.contains(0.0, outside));
}

}  // namespace
}  // namespace fde::bench
