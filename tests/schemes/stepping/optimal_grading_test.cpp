// SPDX-License-Identifier: MIT
// The optimal grading for given orders, against published values and against the rates of a solution.

#include <gtest/gtest.h>

#include "fdebench/schemes/stepping/rates.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

double grading_for(const char* scheme, double order) {
  return optimal_grading(*find_scheme(scheme), scene_of("relaxation", {{"gamma", order}}).problem);
}

// Stynes, O'Riordan & Gracia 2017: (2 - g) / g; rounded up to hundredths.
TEST(OptimalGrading, OfL1IsThatOfStynes) {
  for (const double order : {0.2, 0.3, 0.5, 0.8, 0.95}) {
    const double grading = grading_for("l1", order), published = (2.0 - order) / order;
    EXPECT_GE(grading, published - 1e-6) << order;
    EXPECT_LE(grading, published + 0.01) << order;
  }
}

// The trapezoidal rule has an error h^(2g) in its first step for y ~ t^g, so the grading is 2 / (2g).
TEST(OptimalGrading, OfTheTrapezoidalRuleIsTheInverseOfTheOrder) {
  for (const double order : {0.2, 0.4, 0.5, 0.8}) {
    EXPECT_GE(grading_for("product_trapezoidal", order), 1.0 / order - 1e-6) << order;
    EXPECT_LE(grading_for("product_trapezoidal", order), 1.0 / order + 0.01) << order;
  }
}

TEST(OptimalGrading, IsUniformWhereNothingIsToBeGained) {
  EXPECT_EQ(grading_for("l1", 1.0), 1.0);
  EXPECT_EQ(grading_for("product_trapezoidal", 1.0), 1.0);
  EXPECT_EQ(grading_for("grunwald_letnikov", 0.5), 1.0);  // the only one it takes
  EXPECT_EQ(grading_for("l1", 0.01), 10.0);               // with 199 the first step is 0
}

// 1.2371 is no multiple of 1/64 or more: the commensurate expansion has no links.
TEST(OptimalGrading, IsUniformWhereTheSchemeRefusesTheProblem) {
  EXPECT_EQ(grading_for("commensurate_adams_pc", 1.2371), 1.0);
  EXPECT_EQ(grading_for("multi_term_trapezoidal", 0.5), 1.0);
}

// For a damped oscillation D^alpha u has the largest error: h^((2 - alpha) + (2 - alpha)) at the first step.
TEST(OptimalGrading, OfEquationsFollowsFromTheirTerms) {
  for (const double alpha : {1.2, 1.5, 1.75}) {
    const auto problem = scene_of("damped_oscillator", {{"alpha", alpha}}).problem;
    const double grading = optimal_grading(*find_scheme("multi_term_trapezoidal"), problem);
    EXPECT_NEAR(grading, std::max(1.0, 1.0 / (2.0 - alpha)), 0.011) << alpha;
  }
}

// For a solution that starts with the powers of its orders, no larger grading has a larger rate, and every
// smaller one has a smaller rate.
TEST(OptimalGrading, IsTheLeastWithTheLargestRate) {
  for (const auto* scheme : grid_schemes()) {
    for (const auto* id : {"relaxation", "brusselator", "pendulum", "multi_term"}) {
      const auto scene = scene_of(id);
      if (unsupported_reason(*scheme, scene.problem, Grid{1.0, 8, 2.0})) continue;
      const double grading = optimal_grading(*scheme, scene.problem);
      const Smoothness starts = generic_smoothness(scene.problem);
      const auto rate = [&](double r) {
        return scheme->expected_rate(scene.problem, starts, r, Norm::maximum);
      };
      EXPECT_GE(rate(grading), rate(10.0) - 1e-9) << scheme->id << id;
      if (grading > 1.02) {
        EXPECT_LT(rate(grading - 0.02), rate(10.0) - 1e-6) << scheme->id << id;
      }
    }
  }
}

}  // namespace
}  // namespace fde::bench
