// SPDX-License-Identifier: MIT
// Errors and values of independent published codes for the same problems and steps: fde12 and pi2_im
// (Garrappa, Octave) for adams_pc and product_trapezoidal, pycaputo for l1, an independent C++ program for
// the chain.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

Vec at_end(const Scene& scene, std::string_view scheme, int steps) {
  const auto path = solve(scheme, scene.problem, steps);
  EXPECT_EQ(path.status, SolveStatus::finished);
  return path.y.rightCols(1);
}

struct Published {
  std::string_view scene, scheme;
  double exact, error, tolerance;  // of the first component at the default end, N = 4096; tolerance relative
};

class PublishedError : public testing::TestWithParam<Published> {};

TEST_P(PublishedError, IsReproduced) {
  const auto& p = GetParam();
  const double value = at_end(scene_of(p.scene), p.scheme, 4096)[0];
  EXPECT_NEAR(std::abs(value - p.exact), p.error, p.tolerance * p.error);
}

// By the collocation reference. Published codes extrapolated to 0.3864061345, as if their error were h^2
// alone, without its h^(1+gamma) term; the difference does not matter here.
constexpr double brusselator_x50 = 0.386406136014993;

INSTANTIATE_TEST_SUITE_P(
    , PublishedError,
    testing::Values(Published{"relaxation", "adams_pc", 0.427583576155807, 1.01e-7, 0.02},
                    Published{"relaxation", "product_trapezoidal", 0.427583576155807, 1.23e-7, 0.02},
                    Published{"relaxation", "l1", 0.427583576155807, 1.68e-5, 0.02},
                    Published{"diethelm", "adams_pc", 0.25, 1.00e-6, 0.02},
                    Published{"diethelm", "product_trapezoidal", 0.25, 7.55e-8, 0.02},
                    Published{"brusselator", "adams_pc", brusselator_x50, 5.61e-4, 0.02},
                    Published{"brusselator", "product_trapezoidal", brusselator_x50, 1.06e-4, 0.02}),
    [](const auto& test) { return std::string(test.param.scene) + "__" + std::string(test.param.scheme); });

// The chain of Yin, Liu & Anh at t = 5 with N = 8192, to all printed digits.
TEST(PublishedValue, PendulumWithTheDefaultOrders) {
  Scene scene = scene_of("pendulum");
  scene.problem.end = 5.0;
  const Vec y = at_end(scene, "decoupled_multi_order", 8192);
  EXPECT_NEAR(y[0], 0.2609182055, 1e-10);
  EXPECT_NEAR(y[2], 0.5600178020, 1e-10);
}

TEST(PublishedValue, PendulumWithOrdersFarApart) {
  Scene scene = scene_of("pendulum", {{"alpha", 1.9}, {"beta", 0.1}});
  scene.problem.end = 5.0;
  EXPECT_NEAR(at_end(scene, "decoupled_multi_order", 8192)[0], 0.4354694945, 1e-10);
}

// Its error at t = 20 with N = 2^14, against the collocation reference.
TEST(PublishedValue, ErrorOfThePendulumAtTwenty) {
  const Scene scene = scene_of("pendulum");
  const double exact = reference_of(scene).at(20.0).value[0];
  EXPECT_NEAR(std::abs(at_end(scene, "decoupled_multi_order", 1 << 14)[0] - exact), 5.82e-5, 0.02 * 5.82e-5);
}

TEST(PublishedValue, BrusselatorReference) {
  const double x = reference_of(scene_of("brusselator")).at(50.0).value[0];
  EXPECT_NEAR(x, brusselator_x50, 1e-13);
  EXPECT_NEAR(x, 0.3864061345, 2e-9);
}

}  // namespace
}  // namespace fde::bench
