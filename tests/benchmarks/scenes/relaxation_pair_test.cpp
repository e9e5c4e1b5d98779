// SPDX-License-Identifier: MIT
// D^g u = lambda u with complex lambda is solved by Mittag-Leffler functions; the scene inverts a Laplace
// transform of the real system.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Complex = std::complex<double>;

class RelaxationPair : public testing::TestWithParam<double> {};

// u = u(0) E_g(lambda t^g) + u'(0) t E_{g,2}(lambda t^g).
TEST_P(RelaxationPair, IsTheComplexMittagLefflerFunction) {
  const double g = GetParam();
  const Complex lambda(-1.5, 0.75), start(1.0, -0.5), slope(0.25, 2.0);
  const Scene scene = scene_of("relaxation_pair", {{"gamma", g},
                                                   {"re", lambda.real()},
                                                   {"im", lambda.imag()},
                                                   {"x0", start.real()},
                                                   {"y0", start.imag()},
                                                   {"dx0", slope.real()},
                                                   {"dy0", slope.imag()}});
  for (const double t : {0.0, 1e-3, 0.5, 2.0, 5.0}) {
    const Complex z = lambda * std::pow(t, g);
    const auto even = reference::mittag_leffler(g, 1.0, z), odd = reference::mittag_leffler(g, 2.0, z);
    const Complex u = start * even.value + slope * t * odd.value;
    const double bound = 2.0 * even.bound + 3.0 * t * odd.bound + 1e-14 * (1.0 + std::abs(u));
    const auto known = scene.reference.at(t);
    EXPECT_NEAR(known.value[0], u.real(), known.bound[0] + bound) << t;
    EXPECT_NEAR(known.value[1], u.imag(), known.bound[1] + bound) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(AboveOne, RelaxationPair, testing::Values(1.0 + 0x1p-20, 1.2, 1.5, 1.9, 2.0));

// At order 2 u = cos(w t) u(0) + sin(w t)/w u'(0) with w^2 = -lambda.
TEST(RelaxationPairOfOrderTwo, IsAComplexOscillator) {
  const Complex lambda(-1.0, 2.0), w = std::sqrt(-lambda);
  const Scene scene = scene_of("relaxation_pair", {{"gamma", 2.0}, {"dx0", 0.5}, {"dy0", -1.0}});
  for (const double t : {0.25, 1.0, 4.0}) {
    const Complex u = std::cos(w * t) + Complex(0.5, -1.0) * std::sin(w * t) / w;
    const auto known = scene.reference.at(t);
    EXPECT_NEAR(known.value[0], u.real(), 1e-14 * std::abs(u)) << t;
    EXPECT_NEAR(known.value[1], u.imag(), 1e-14 * std::abs(u)) << t;
  }
}

// y starts with a power that x does not have where lambda is imaginary: D^g y = |lambda| x, D^g x = -|lambda|
// y.
TEST(RelaxationPairOfOrderAboveOne, StartsWithThePowersOfItsSeries) {
  const auto powers =
      scene_of("relaxation_pair", {{"gamma", 1.25}, {"re", 0.0}, {"dx0", 0.5}}).smoothness.powers;
  EXPECT_EQ(powers[0], (std::vector{2.5}));
  EXPECT_EQ(powers[1], (std::vector{1.25, 2.25}));
}

TEST(RelaxationPairUpToOne, HasNoSlope) {
  expect_message(
      [] {
        scene_of("relaxation_pair", {{"dx0", 1.0}});
      },
      "dx0 = 1: must be 0 when gamma is at most 1");
}

}  // namespace
}  // namespace fde::bench
