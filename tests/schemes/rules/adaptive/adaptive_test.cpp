// SPDX-License-Identifier: MIT
// Adaptive step size: accuracy and cost.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/schemes/rules/adaptive/step_control.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr std::array step_rules{"adaptive_trapezoidal", "adaptive_pc", "radau_exponentials"};

class Adaptive : public testing::TestWithParam<AccuracyRun> {};

// The error is estimated for each step; the global error stays within three times the tolerance here.
TEST_P(Adaptive, DeliversTheAccuracy) {
  const auto& [scheme, id, values] = GetParam();
  const Scene scene = scene_of(id, values);
  const auto reference = reference_of(scene);
  const bool third_order = scheme == "radau_exponentials";
  for (const double accuracy : {1e-3, third_order ? 1e-7 : 1e-5}) {
    const auto path = solve(scheme, scene.problem, Tolerance{accuracy, accuracy});
    ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
    EXPECT_EQ(path.last_time, scene.problem.end);
    EXPECT_EQ(path.steps, std::ssize(path.times) - 1);
    EXPECT_TRUE(path.cost.rejected_steps);
    EXPECT_LT(largest_error(scene, reference, path), 3.0 * accuracy) << accuracy;
  }
}

std::vector<AccuracyRun> smooth_and_singular() {
  std::vector<AccuracyRun> all;
  for (const auto* scheme : step_rules) {
    for (const auto* scene : {"relaxation", "diethelm", "linear_system", "fractional_oscillator", "pendulum",
                              "bagley_torvik", "damped_oscillator"})
      all.push_back({scheme, scene});
    all.push_back({scheme, "relaxation", {{"gamma", 0.1}}});
    all.push_back({scheme, "relaxation", {{"gamma", 1.7}}});
    all.push_back({scheme, "power", {{"gamma", 0.2}, {"p", 0.3}}});
  }
  return all;
}

// Stiff, with constraints, and with sparse derivatives.
std::vector<AccuracyRun> hard() {
  const auto multiplier = [](const char* scene) {
    return AccuracyRun{"radau_exponentials", scene, {{"formulation", "multiplier"}}};
  };
  return {{"adaptive_trapezoidal", "stiff_relaxation"},
          {"radau_exponentials", "stiff_relaxation", {{"lambda", -1e8}}},
          {"radau_exponentials", "brusselator"},
          {"radau_exponentials", "van_der_pol", {{"mu", 1e4}}},
          {"radau_exponentials", "robertson"},
          {"adaptive_trapezoidal", "fractional_diffusion"},
          {"radau_exponentials", "fractional_diffusion"},
          {"radau_exponentials", "nonlinear_fractional_oscillator", {{"form", "multiplier"}}},
          multiplier("nonholonomic_particle"),
          multiplier("loxodrome"),
          multiplier("isokinetic"),
          multiplier("fractional_knife_edge"),
          multiplier("fractional_constraint_2d"),
          multiplier("fractional_constraint_nonlinear")};
}

INSTANTIATE_TEST_SUITE_P(SceneRegistry, Adaptive, testing::ValuesIn(smooth_and_singular()), name_of_run);
INSTANTIATE_TEST_SUITE_P(HardScenes, Adaptive, testing::ValuesIn(hard()), name_of_run);

// D^0.5 y = t^p, y(0) = 0: y = Gamma(p+1)/Gamma(p+1.5) t^(p+0.5).
TEST(AdaptiveRules, AreExactForTheirPolynomials) {
  const auto error_of = [](const char* scheme, double p) {
    const Problem problem{.components = {{0.5, {0.0}}},
                          .rhs = [=](double t, In, Out f) { f[0] = std::pow(t, p); }};
    const auto path = solve(scheme, problem, Tolerance{1e-4, 1e-4}, {.output_times = {1.0}});
    return std::abs(path.y(0, 0) - std::tgamma(p + 1.0) / std::tgamma(p + 1.5));
  };
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc"}) {
    EXPECT_LT(error_of(scheme, 1.0), 1e-14) << scheme;
    EXPECT_GT(error_of(scheme, 2.0), 1e-9) << scheme;
  }
  EXPECT_LT(error_of("radau_exponentials", 2.0), 1e-14);
  EXPECT_GT(error_of("radau_exponentials", 3.0), 1e-12);
}

// For y' = -y the error estimates fall with the square of the step size, for Radau with the fourth power.
TEST(AdaptiveRules, TakeAsManyStepsAsTheirRateSays) {
  const Problem problem{
      .components = {{1.0, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }, .end = 10.0};
  const auto more_steps = [&](const char* scheme) {
    const auto steps = [&](double accuracy) {
      return static_cast<double>(solve(scheme, problem, Tolerance{accuracy, accuracy}).steps);
    };
    return steps(1e-8) / steps(1e-6);
  };
  EXPECT_NEAR(more_steps("adaptive_trapezoidal"), 10.0, 1.0);
  EXPECT_NEAR(more_steps("adaptive_pc"), 10.0, 1.0);
  EXPECT_NEAR(more_steps("radau_exponentials"), std::sqrt(10.0), 0.3);
}

TEST(AdaptiveMemory, DoesNotGrowWithTheSteps) {
  const Scene scene = scene_of("brusselator");
  const auto bytes = [&](const char* scheme, double accuracy) {
    const auto path = solve(scheme, scene.problem, Tolerance{accuracy, accuracy});
    return static_cast<double>(path.cost.history_bytes.value());
  };
  for (const auto* scheme : {"adaptive_trapezoidal", "radau_exponentials"})
    EXPECT_LT(bytes(scheme, 1e-5), 1.2 * bytes(scheme, 1e-3)) << scheme;
}

// D^0.5 y = -1e6 y: the error is relative to y at the end, not to y(0).
TEST(AdaptiveStiff, KeepsTheDigitsOfWhatIsLeft) {
  const Scene scene = scene_of("stiff_relaxation");
  const double exact = reference::mittag_leffler(0.5, 1.0, -1e6);
  for (const auto* scheme : {"adaptive_trapezoidal", "radau_exponentials"}) {
    const auto path = solve(scheme, scene.problem, Tolerance{1e-4, 1e-300}, {.output_times = {1.0}});
    EXPECT_NEAR(path.y(0, 0) / exact, 1.0, 1e-4) << scheme;
  }
}

// y' = -1, y(0) = 1: y leaves y > 0 at t = 1.
TEST(AdaptiveEnd, IsLocatedWhereTheDomainEnds) {
  Problem problem{.components = {{1.0, {1.0}}}, .rhs = [](double, In, Out f) { f[0] = -1.0; }, .end = 3.0};
  problem.domain = {"y = 0", [](double, In y) { return y[0]; }};
  for (const auto* scheme : step_rules) {
    const auto path = solve(scheme, problem, Tolerance{1e-3, 1e-3});
    EXPECT_EQ(path.status, SolveStatus::left_domain) << scheme;
    EXPECT_NEAR(path.last_time, 1.0, 1e-14) << scheme;
  }
}

// D^0.5 y = 1, and -1 where y > 1: at y = 1 neither side leads away from it.
TEST(AdaptiveEnd, IsWhereARunSlidesAlongASwitch) {
  const Problem problem{.components = {{0.5, {0.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = y[0] > 1.0 ? -1.0 : 1.0; },
                        .end = 2.0,
                        .switching_functions = {[](double, In y) { return y[0] - 1.0; }}};
  for (const auto* scheme : step_rules) {
    const auto path = solve(scheme, problem, Tolerance{1e-4, 1e-4}, {.budget = 20.0});
    EXPECT_EQ(path.status, SolveStatus::sliding) << scheme;
    EXPECT_NEAR(path.last_time, M_PI / 4.0, 1e-3) << scheme;
  }
}

// For order 0.8 the solution grows like (t_b - t)^-0.8, t_b = 0.629.
TEST(AdaptiveEnd, IsNamedWhereTheSolutionBlowsUp) {
  const auto expect = [](const char* scheme, double order, double time) {
    const auto path = solve(scheme, blow_up_problem(order), Tolerance{0.1, 0.1}, {.output_times = {0.5}});
    EXPECT_EQ(path.status, SolveStatus::blow_up) << scheme << ' ' << order;
    EXPECT_NEAR(path.failure_time.value(), time, 1e-2) << scheme << ' ' << order;
  };
  expect("radau_exponentials", 1.0, 1.0);
  for (const auto* scheme : step_rules) expect(scheme, 0.8, 0.6288);
}

// y' = 300 y, y(0) = 1: y(1) = 1e130.
TEST(AdaptiveEnd, IsNoneWhereTheSolutionGrowsExponentially) {
  const Problem problem{.components = {{1.0, {1.0}}}, .rhs = [](double, In y, Out f) { f = 300.0 * y; }};
  for (const auto* scheme : step_rules) {
    const auto path = solve(scheme, problem, Tolerance{1e-2, 1e-2});
    EXPECT_EQ(path.status, SolveStatus::finished) << scheme;
  }
}

// y' = 1 / (1 - t), y(0) = 0: y = -log(1 - t), and steps become as short as the rounding of t where y = 36.
TEST(AdaptiveEnd, IsThatNoStepIsShortEnoughWhereTheRightHandSideIsNotIntegrable) {
  const Problem problem{
      .components = {{1.0, {0.0}}}, .rhs = [](double t, In, Out f) { f[0] = 1.0 / (1.0 - t); }, .end = 2.0};
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc"}) {
    const auto path = solve(scheme, problem, Tolerance{0.3, 0.3}, {.output_times = {0.5}});
    EXPECT_EQ(path.status, SolveStatus::step_too_small) << scheme;
    EXPECT_NEAR(path.last_time, 1.0, 1e-12) << scheme;
  }
}

// Components of order 0.02 start with steps of 1e-220, whose square underflows; the diffusion equation of
// this order is close to its final state at once.
TEST(AdaptiveStart, MayBeShorterThanTheRootOfTheSmallestDouble) {
  const Scene scene = scene_of("fractional_diffusion", {{"gamma", 0.02}});
  for (const auto* scheme : {"adaptive_trapezoidal", "radau_exponentials"}) {
    const auto path = solve(scheme, scene.problem, Tolerance{3e-6, 3e-6}, {.output_times = {0.5, 1.0}});
    ASSERT_EQ(path.status, SolveStatus::finished) << scheme;
    EXPECT_LT(largest_error(scene, reference_of(scene), path), 3e-5) << scheme;
  }
}

TEST(AdaptiveJumps, AreDetectedWhereTheyAreNotListed) {
  for (const auto* scheme : step_rules) {
    const auto path =
        solve(scheme, jumping_problem({}), Tolerance{1e-5, 1e-5}, {.output_times = {0.5, 1.25, 3.0}});
    ASSERT_EQ(path.status, SolveStatus::finished) << scheme;
    SCOPED_TRACE(scheme);
    expect_row(path, 0, solution_of_jumping_problem, 1e-5);
  }
}

// D^0.9 y = sign(sin 3t) - y jumps at every multiple of pi/3. Both rules are as accurate without the list of
// jumps.
TEST(AdaptiveJumps, AreFoundOneAfterTheOther) {
  Problem problem{.components = {{0.9, {0.0}}},
                  .rhs = [](double t, In y, Out f) { f[0] = (std::sin(3.0 * t) > 0.0 ? 1.0 : -1.0) - y[0]; },
                  .end = 5.0};
  Problem declared = problem;
  for (double jump = M_PI / 3.0; jump < 5.0; jump += M_PI / 3.0) declared.jump_times.push_back(jump);
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc"}) {
    const auto y = [&](const Problem& one) {
      const auto path = solve(scheme, one, Tolerance{1e-5, 1e-5}, {.output_times = {2.0, 5.0}});
      EXPECT_EQ(path.status, SolveStatus::finished) << scheme;
      return path.y;
    };
    EXPECT_LT((y(problem) - y(declared)).cwiseAbs().maxCoeff(), 2e-5) << scheme;
  }
}

// A component of order 0.05 that starts from 0 needs a first step far shorter than 1e-14 of the end, where
// t^0.05 is 0.2.
TEST(AdaptiveStart, IsShortEnoughForRowsOfLowOrder) {
  const Scene pendulum = scene_of("pendulum", {{"alpha", 1.95}});
  const Scene system = scene_of(
      "linear_system",
      {{"gamma1", 0.04521}, {"gamma2", 0.962}, {"x0", 0.0}, {"y0", 0.0}, {"c1", -1.742}, {"c2", 0.7194}});
  for (const auto* scheme : step_rules) {
    for (const Scene* scene : {&pendulum, &system}) {
      const auto path = solve(scheme, scene->problem, Tolerance{1e-4, 1e-4}, {.budget = 20.0});
      ASSERT_EQ(path.status, SolveStatus::finished) << scheme << ' ' << path.last_time;
      EXPECT_LT(largest_error(*scene, reference_of(*scene), path), 1e-3) << scheme;
    }
  }
}

// Diffusion of a step: components far from it are 1e-300, and their squared relative errors overflow. Every
// result is bounded by the initial values.
TEST(AdaptiveTrapezoidal, ReturnsNoGrownResultOfDiffusion) {
  const Scene scene = scene_of("fractional_diffusion", {{"start", "step"}});
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc"}) {
    const auto path = solve(scheme, scene.problem, Tolerance{2e-3, 2e-3}, {.budget = 2.0});
    EXPECT_LE(path.y.cwiseAbs().maxCoeff(), 1.1) << scheme;
  }
}

// Components of orders 0.71 and 1.6: errors of the first decay, errors of the second accumulate.
TEST(AdaptiveTrapezoidal, AddsUpErrorsOfEachOrderByItself) {
  const Scene scene = scene_of("linear_system", {{"gamma1", 0.7089},
                                                 {"gamma2", 1.616},
                                                 {"a11", -4.393},
                                                 {"a12", 0.2863},
                                                 {"a21", -0.5975},
                                                 {"a22", -2.997},
                                                 {"x0", -0.08613},
                                                 {"y0", 1.451},
                                                 {"dy0", 0.6468},
                                                 {"c1", -1.348},
                                                 {"c2", -1.827}});
  const auto path = solve("adaptive_trapezoidal", scene.problem, Tolerance{1e-8, 1e-8});
  EXPECT_LT(largest_error(scene, reference_of(scene), path), 3e-8);
}

TEST(PiController, AcceptsErrorsUpToTheTolerance) {
  PiController control(2.0, 1.0);
  EXPECT_TRUE(control.update(1.0, 1.0));
  EXPECT_FALSE(control.update(1.01, 1.0));
  EXPECT_FALSE(control.update(std::nan(""), 1.0));
}

TEST(PiController, AimsBelowTheTolerance) {
  PiController control(2.0, 1.0);
  control.update(4.0, 1.0);  // the error of half the step would be 1
  EXPECT_DOUBLE_EQ(control.length(), 0.4);
  control.update(std::numeric_limits<double>::infinity(), 0.4);
  EXPECT_DOUBLE_EQ(control.length(), 0.1);
}

TEST(PiController, KeepsALengthThatMayHardlyGrow) {
  PiController control(2.0, 1.0);
  control.update(0.5, 1.0);
  EXPECT_EQ(control.length(), 1.0);
}

TEST(PiController, DoesNotGrowRightAfterARejection) {
  PiController control(2.0, 1.0);
  control.update(2.0, 1.0);
  const double length = control.length();
  control.update(1e-6, length);
  EXPECT_EQ(control.length(), length);
  control.update(1e-6, length);
  EXPECT_EQ(control.length(), 4.0 * length);
}

}  // namespace
}  // namespace fde::bench
