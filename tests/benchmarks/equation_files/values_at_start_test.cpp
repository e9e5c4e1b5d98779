// SPDX-License-Identifier: MIT
// Right-hand sides that are 0/0 or no number at t = 0.

#include "fdebench/benchmarks/expressions/values_at_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

double rhs_at(const Scene& scene, double t) {
  Vec f(1);
  scene.problem.rhs(t, Vec::Zero(1), f);
  return f[0];
}

struct Removable {
  std::string formula;
  double limit, slope;  // at t = 0
};

class RemovableSingularity : public testing::TestWithParam<Removable> {};

// De l'Hospital's limits, and no cancellation next to t = 0.
TEST_P(RemovableSingularity, HasItsLimit) {
  const auto& [formula, limit, slope] = GetParam();
  const Scene scene = scene_of_text(relaxation_file(formula + " - x"));
  EXPECT_NEAR(rhs_at(scene, 0.0), limit, 1e-15 * (1.0 + std::abs(limit)));
  for (const double t : {1e-300, 1e-15, 1e-8, 1e-4})
    EXPECT_NEAR(rhs_at(scene, t), limit + slope * t, 2.0 * t * t + 1e-15) << t;
}

INSTANTIATE_TEST_SUITE_P(Quotients, RemovableSingularity,
                         testing::Values(Removable{"sin(t)/t", 1.0, 0.0},
                                         Removable{"(1 - cos(2*t))/t^2", 2.0, 0.0},
                                         Removable{"3*(exp(t) - 1)/(2*t)", 1.5, 0.75},
                                         Removable{"log(1 + t)/sin(t)", 1.0, -0.5},
                                         Removable{"(t - sin(t))/t^3 + cos(t)", 7.0 / 6.0, 0.0},
                                         Removable{"t^2/t", 0.0, 1.0}, Removable{"sin(t)^2/t", 0.0, 1.0}));

TEST(RemovableSingularity, IsTheFormulaAwayFromIt) {
  const Scene scene = scene_of_text(relaxation_file("(1 - cos(t))/t^2 - x"));
  for (const double t : {0.01, 0.1, 0.5, 1.0}) {
    const double half = std::sin(t / 2.0) / t;
    EXPECT_NEAR(rhs_at(scene, t), 2.0 * half * half, 1e-14) << t;
  }
}

// D^0.5 x = g(t) - x by the series of g and Mittag-Leffler functions, in mpmath.
TEST(RemovableSingularity, HasAReference) {
  const auto [value, bound] = reference_of(scene_of_text(relaxation_file("sin(t)/t - x"))).at(1.0);
  EXPECT_NEAR(value[0], 0.9386659913, 1e-10);
  EXPECT_LT(bound[0], 1e-12);
}

TEST(NoNumber, IsNamedWithItsPlace) {
  expect_message(
      [] { scene_of_text(relaxation_file("step(t - 0.25)*sqrt(t - 0.25) - x")); },
      "line 4, column 8: sqrt(t - 0.25) is not a number at t = 0 with the initial values 1: must be one");
  expect_message([] { scene_of_text(relaxation_file("log(-x) + t")); }, "log(-x) is not a number at t = 0");
}

// t log(t) is 0 times infinity at t = 0 only.
TEST(NoNumber, AtTheStartOnlyIsLeftToTheSchemes) {
  EXPECT_TRUE(std::isfinite(rhs_at(scene_of_text(relaxation_file("t*log(t) - x")), 0.5)));
}

}  // namespace
}  // namespace fde::bench
