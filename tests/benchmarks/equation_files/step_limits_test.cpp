// SPDX-License-Identifier: MIT
// Loads that change quickly limit the steps where they do, wherever that is and however short.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

Problem at_rest(const std::string& rhs, double end, const std::string& order = "0.9") {
  return scene_of_text("end = " + std::to_string(end) + "\n[unknown.x]\norder = " + order + "\nrhs = \"" +
                       rhs + "\"\ninitial = [" + (std::stod(order) > 1.0 ? "0, 0" : "0") + "]\n")
      .problem;
}

TEST(StepLimits, FindPulsesOfAnyWidthAnywhere) {
  for (const double width : {1e-7, 1e-4, 1e-2}) {
    for (const double place : {0.3, 5.0, 9.9973}) {
      const auto rhs =
          "exp(-((t - " + std::to_string(place) + ")/" + std::to_string(1e9 * width) + "e-9)^2) - x";
      const Problem problem = at_rest(rhs, 10.0);
      EXPECT_LE(longest_step(problem, place - 1e-3 * width), 2.0 * width) << rhs;
      // A step from afar ends where the pulse begins.
      const double from = 0.5 * place;
      EXPECT_LE(from + longest_step(problem, from), place + 2.0 * width) << rhs;
    }
  }
}

// cos t hides the pulse: their sum has turning points elsewhere, and on its steep part none that is near.
TEST(StepLimits, FindPulsesOnSlopes) {
  for (const auto* rhs :
       {"cos(t) + 0.01*exp(-((t - 5)/1e-3)^2) - x", "20*t + 0.01*exp(-((t - 5)/1e-3)^2) - x"})
    EXPECT_LE(longest_step(at_rest(rhs, 10.0), 5.0 - 1e-4), 2e-3) << rhs;
}

TEST(StepLimits, AreFirstRunsOfOscillations) {
  const Problem problem = at_rest("sin(pi*t) - x", 10.0);
  EXPECT_LE(longest_step(problem, 0.0), 0.5 + 1e-12);
  EXPECT_GE(longest_step(problem, 3.7), 10.0);
}

// The slopes of triangles and ramps jump.
TEST(StepLimits, FindTrianglesAndRamps) {
  const Problem triangle = at_rest("3*max(0, 1 - abs(t - 4.26)/0.02) - x", 10.0);
  EXPECT_LE(longest_step(triangle, 4.245), 0.02);
  EXPECT_LE(1.0 + longest_step(triangle, 1.0), 4.26);
  EXPECT_EQ(triangle.kink_times.size(), 3U);
  const Problem ramp = at_rest("min(1, max(0, (t - 2.2)/0.1)) - x", 10.0);
  EXPECT_LE(longest_step(ramp, 2.21), 0.1);
  EXPECT_LE(1.0 + longest_step(ramp, 1.0), 2.3);
}

TEST(StepLimits, AreNoneOfSlowLoads) {
  for (const auto* rhs : {"1 - x", "t^2 - x", "exp(-t) - x", "-x^3 + t", "t*x"})
    EXPECT_GE(longest_step(at_rest(rhs, 1.0), 0.0), 1.0) << rhs;
}

// Schemes that control their steps see a pulse that none of their steps would have sampled: the integral of
// the load is known, J^g of a pulse of area A at distance d is A d^(g-1) / Gamma(g), up to the width.
TEST(StepLimits, LetAdaptiveSchemesSeePulses) {
  const double g = 0.9, width = 1e-3, place = 5.0, end = 10.0;
  const Problem problem = at_rest("exp(-((t - 5)/1e-3)^2)/1e-3", end);
  const double exact = std::sqrt(std::numbers::pi) * std::pow(end - place, g - 1.0) / std::tgamma(g);
  for (const auto* id :
       {"adaptive_pc", "adaptive_trapezoidal", "radau_exponentials", "spectral_collocation"}) {
    const Trajectory path = find_scheme(id)->solve(problem, Tolerance{1e-6, 1e-6}, {.output_times = {end}});
    ASSERT_EQ(path.status, SolveStatus::finished) << id;
    EXPECT_NEAR(path.y(0, path.y.cols() - 1), exact, 1e-4 * exact + width * width) << id;
  }
}

// J^g of a triangle of height 1 is ((t-a)^(1+g) - 2 (t-b)^(1+g) + (t-c)^(1+g)) / (w Gamma(2+g)) behind its
// kinks a < b < c, w apart.
TEST(StepLimits, LetAdaptiveSchemesStopAtKinks) {
  const double g = 0.9, w = 0.02, place = 4.26, end = 10.0, tolerance = 1e-8;
  const Problem problem = at_rest("max(0, 1 - abs(t - 4.26)/0.02)", end);
  const auto power = [&](double kink) { return std::pow(end - kink, 1.0 + g); };
  const double exact =
      (power(place - w) - 2.0 * power(place) + power(place + w)) / (w * std::tgamma(2.0 + g));
  for (const auto* id :
       {"adaptive_pc", "adaptive_trapezoidal", "radau_exponentials", "spectral_collocation"}) {
    const auto path =
        find_scheme(id)->solve(problem, Tolerance{tolerance, tolerance}, {.output_times = {end}});
    ASSERT_EQ(path.status, SolveStatus::finished) << id;
    EXPECT_NEAR(path.y(0, path.y.cols() - 1), exact, 10.0 * tolerance * (1.0 + exact)) << id;
  }
}

}  // namespace
}  // namespace fde::bench
