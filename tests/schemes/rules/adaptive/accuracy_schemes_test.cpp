// SPDX-License-Identifier: MIT
// Properties of every scheme with a tolerance and adaptive step size.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class AccuracyScheme : public testing::TestWithParam<const Scheme*> {
 protected:
  static Trajectory run(const Problem& problem, double accuracy, Options options = {}) {
    options.budget = 2.0;
    return GetParam()->solve(problem, Tolerance{accuracy, accuracy}, options);
  }
  static bool is_spectral() { return GetParam()->id == "spectral_collocation"; }
};

Problem half_order_relaxation() { return scene_of("relaxation").problem; }
double solution_of_half_order_relaxation(double t) {
  return reference::mittag_leffler(0.5, 1.0, -std::sqrt(t));
}

Component one_of_order(double order) {
  return {order, order > 1.0 ? std::vector{1.0, 0.0} : std::vector{1.0}};
}

TEST_P(AccuracyScheme, KeepsConstants) {
  for (const double order : {0.2, 0.5, 1.0, 1.5, 2.0}) {
    const Problem problem{.components = {{order, order > 1.0 ? std::vector{3.25, 0.0} : std::vector{3.25}}},
                          .rhs = [](double, In, Out f) { f.setZero(); }};
    EXPECT_EQ((run(problem, 1e-6).y.array() - 3.25).abs().maxCoeff(), 0.0) << order;
  }
}

TEST_P(AccuracyScheme, SolvesUncoupledRowsAsAlone) {
  const Problem both{.components = {one_of_order(0.4), one_of_order(1.6)},
                     .rhs = [](double, In y, Out f) { f = -y; }};
  const double accuracy = is_spectral() ? 1e-10 : 1e-6, allowed = is_spectral() ? accuracy : 3.0 * accuracy;
  const auto path = run(both, accuracy, {.output_times = {1.0}});
  EXPECT_NEAR(path.y(0, 0), reference::mittag_leffler(0.4, 1.0, -1.0), allowed);
  EXPECT_NEAR(path.y(1, 0), reference::mittag_leffler(1.6, 1.0, -1.0), allowed);
}

TEST_P(AccuracyScheme, DoesNotDependOnTheOrderOfRows) {
  const auto run_of = [&](double first, double second) {
    const Problem problem{.components = {one_of_order(first), one_of_order(second)},
                          .rhs = [](double, In y, Out f) { f = -y; },
                          .derivatives = DenseLinearPart{-Matrix::Identity(2, 2)}};
    return run(problem, 1e-5);
  };
  const auto path = run_of(0.4, 0.9), exchanged = run_of(0.9, 0.4);
  ASSERT_EQ(path.times, exchanged.times);
  EXPECT_LT((path.y - exchanged.y.colwise().reverse()).cwiseAbs().maxCoeff(), 1e-14);
}

TEST_P(AccuracyScheme, ReturnsRequestedTimesOnAndBetweenSteps) {
  const std::vector<double> at{1e-6, 0.013, 0.5, 0.77, 1.0};
  const auto path = run(half_order_relaxation(), 1e-6, {.output_times = at});
  ASSERT_EQ(path.times, at);
  expect_row(path, 0, solution_of_half_order_relaxation, 1e-6);
}

TEST_P(AccuracyScheme, ReturnsTimesThatAreRoundingApart) {
  const std::vector<double> at{0.5, std::nextafter(0.5, 1.0), 0.5 + 1e-14, std::nextafter(1.0, 0.0), 1.0};
  EXPECT_EQ(run(half_order_relaxation(), 1e-6, {.output_times = at}).times, at);
}

// D^0.5 y = 1, which one step may solve: y = t^0.5 / Gamma(1.5).
TEST_P(AccuracyScheme, HasTheSameRelativeAccuracyAtTheStart) {
  const Problem problem{.components = {{0.5, {0.0}}}, .rhs = [](double, In, Out f) { f[0] = 1.0; }};
  const std::vector<double> at{1e-60, 1e-30, 1e-17, 1e-6};
  const auto path = run(problem, 1e-6, {.output_times = at});
  ASSERT_EQ(path.times, at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double exact = std::sqrt(at[i]) / std::tgamma(1.5);
    EXPECT_NEAR(path.y(0, static_cast<Eigen::Index>(i)) / exact, 1.0, 1e-9) << at[i];
  }
}

// D^g y = lambda y: the error of f is lambda times the error of y, and dense output from f alone would have
// an error of that size between steps.
TEST_P(AccuracyScheme, DenseOutputOfStiffRowsIsAccurate) {
  if (!GetParam()->capabilities.implicit) GTEST_SKIP() << "is not for stiff problems";
  constexpr double within = 1e-4;  // a factor of ten
  for (const double order : {0.36, 0.9, 1.4}) {
    const Scene scene = scene_of("stiff_relaxation", {{"gamma", order}, {"lambda", -1e7}});
    const std::vector<double> at{1e-6, 1e-3, 0.3125, 0.4375, 0.8125};
    const auto path = run(scene.problem, 1e-5), asked = run(scene.problem, 1e-5, {.output_times = at});
    ASSERT_EQ(asked.times, at);
    SCOPED_TRACE(order);
    const auto exact = [&](double t) { return scene.reference.at(t).value[0]; };
    expect_row(asked, 0, exact, within);
    for (const double t : at) EXPECT_NEAR(path.dense_output(t)[0], exact(t), within) << t;
    expect_row(path, 0, exact, within, 64);
  }
}

// Where the equations hardly damp an error of f, the integral of f is more accurate within long steps than
// interpolation of y at their ends.
TEST_P(AccuracyScheme, DenseOutputOfLongStepsIsAccurate) {
  const Scene scene = scene_of("diethelm", {{"gamma", 0.33}});
  const std::vector<double> at{0.0625, 0.15, 0.2, 0.25, 0.3125, 0.8};
  const auto path = run(scene.problem, 6.6e-4, {.output_times = at});
  ASSERT_EQ(path.times, at);
  expect_row(
      path, 0, [&](double t) { return scene.reference.at(t).value[0]; }, 1.3e-2);
}

// After a corrector, f is one correction ahead of y.
TEST_P(AccuracyScheme, HasDenseOutput) {
  const auto path = run(half_order_relaxation(), 1e-6);
  ASSERT_TRUE(path.dense_output);
  for (const double t : {1e-9, 1e-4, 0.013, 0.5, 0.77, 1.0})
    EXPECT_NEAR(path.dense_output(t)[0], solution_of_half_order_relaxation(t), 2e-6) << t;
  expect_row(
      path, 0, [&](double t) { return path.dense_output(t)[0]; }, 1e-8, 16);
}

// y' = z and 0 = y + z: y = e^-t. The error estimate is for y; z between the points of a step is a parabola.
TEST_P(AccuracyScheme, HasDenseOutputOfAlgebraicRows) {
  const Problem problem{.components = {{1.0, {1.0}}, {0.0, {-1.0}}},
                        .rhs = [](double, In y, Out f) { f << y[1], y[0] + y[1]; }};
  if (unsupported_reason(*GetParam(), problem, Tolerance{1e-6, 1e-6}))
    GTEST_SKIP() << "takes no algebraic rows";
  const auto path = run(problem, 1e-6);
  for (const double t : {0.1, 0.35, 0.9}) {
    EXPECT_NEAR(path.dense_output(t)[0], std::exp(-t), 2e-6) << t;
    EXPECT_NEAR(path.dense_output(t)[1], -std::exp(-t), 1e-4) << t;
  }
}

// v = 1 - J^1/2 v begins like a power of t, v = E_1/2,1(-t^1/2), as the solution of Abel's equation of the
// second kind.
TEST_P(AccuracyScheme, HasDenseOutputOfAlgebraicRowsInTheFirstStep) {
  const Problem problem{.components = {{0.5, {0.0}}, {0.0, {1.0}}},
                        .rhs = [](double, In y, Out f) { f << y[1], 1.0 - y[0] - y[1]; },
                        .derivatives = DenseLinearPart{Matrix{{0.0, 1.0}, {-1.0, -1.0}}}};
  if (unsupported_reason(*GetParam(), problem, Tolerance{1e-6, 1e-6}))
    GTEST_SKIP() << "takes no algebraic rows";
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    std::vector<double> at;
    for (double t = 1e-14; t < 0.5; t *= std::sqrt(10.0)) at.push_back(t);
    at.push_back(1.0);
    const auto path = run(problem, accuracy, {.output_times = at});
    ASSERT_EQ(path.times, at) << accuracy;
    const auto all = run(problem, accuracy);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double exact = solution_of_half_order_relaxation(at[i]), allowed = 3.0 * accuracy + 1e-14;
      EXPECT_NEAR(path.y(1, static_cast<Eigen::Index>(i)), exact, allowed) << accuracy << ' ' << at[i];
      if (all.dense_output) {
        EXPECT_NEAR(all.dense_output(at[i])[1], exact, allowed) << accuracy << ' ' << at[i];
      }
    }
  }
}

// y + J^1/2 y^3 = g(t) with y = t^p, which is a power of t within the first step, too.
TEST_P(AccuracyScheme, FollowsAPowerOfTimeInAVolterraEquation) {
  for (const double p : {0.5, 1.5}) {
    const Scene scene = scene_of("volterra_equation", {{"p", p}});
    if (unsupported_reason(*GetParam(), scene.problem, Tolerance{1e-6, 1e-6}))
      GTEST_SKIP() << "takes no algebraic rows";
    for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
      const auto path = run(scene.problem, accuracy);
      ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
      for (double t = 1e-12; t < 7.0; t *= 1.7) {
        const double y = columns_at(scene.outputs, t, path.dense_output(t))[0];
        EXPECT_NEAR(y, std::pow(t, p), 3.0 * accuracy * (1.0 + y)) << p << ' ' << accuracy << ' ' << t;
      }
    }
  }
}

// A multiplier that starts like t^-0.38, which a first step does not resolve: at the end of the step the
// constraint removes the error that this leaves in the velocities.
TEST_P(AccuracyScheme, DenseOutputOfConstrainedRowsIsAccurateInTheFirstStep) {
  const Scene scene = make_scene(scene_factory("fractional_constraint_2d"),
                                 {{"alpha", 0.376}, {"formulation", std::string("multiplier")}});
  if (unsupported_reason(*GetParam(), scene.problem, Tolerance{1e-7, 1e-7}))
    GTEST_SKIP() << "takes no algebraic rows";
  const std::vector<double> at{1e-8, 1e-6, 6e-6, 1e-5, 1e-4};
  const auto path = run(scene.problem, 1e-7, {.output_times = at});
  ASSERT_EQ(path.times, at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec columns = columns_at(scene.outputs, at[i], path.y.col(static_cast<Eigen::Index>(i)));
    EXPECT_LT((columns - scene.reference.at(at[i]).value).lpNorm<Eigen::Infinity>(), 1e-6) << at[i];
  }
}

TEST_P(AccuracyScheme, RestartsAfterAJumpOfTheRightHandSide) {
  const auto path = run(jumping_problem({1.0}), 1e-6);
  ASSERT_EQ(path.last_time, 3.0);
  expect_row(path, 0, solution_of_jumping_problem, 1e-6);
}

// If a row of order 0.37 contains the jump, f varies so fast next to it that the steps are short compared
// with any time.
TEST_P(AccuracyScheme, RestartsInRowsOfLowOrder) {
  const Scene scene = scene_of("bagley_torvik", {{"alpha", 1.63}, {"B", 0.95}, {"load_until", 2.7}});
  const auto path = run(scene.problem, 1e-5, {.output_times = {4.0}});
  ASSERT_EQ(path.status, SolveStatus::finished);
  EXPECT_NEAR(path.y(0, 0), scene.reference.at(4.0).value[0], 1e-4);
}

TEST_P(AccuracyScheme, LocatesWhereTheStateMakesTheRightHandSideJump) {
  const auto path = run(switching_problem(), 1e-5);
  ASSERT_EQ(path.status, SolveStatus::finished);
  expect_row(path, 0, solution_of_switching_problem, 1e-4);
}

// y'' = -y - sign(y') / 10, y(0) = 1, y'(0) = 0.
Problem dry_friction(double end) {
  const auto sign = [](double v) { return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : 0.0; };
  return {.components = {{1.0, {1.0}}, {1.0, {0.0}}},
          .rhs = [=](double, In y, Out f) { f << y[1], -y[0] - 0.1 * sign(y[1]); },
          .end = end,
          .switching_functions = {[](double, In y) { return y[1]; }}};
}

// Half waves about +1/10 and -1/10, turning at every multiple of pi.
TEST_P(AccuracyScheme, FollowsDryFriction) {
  const Problem problem = dry_friction(9.0);
  const std::vector<double> at{1.0, 3.0, 4.0, 6.0, 7.0, 9.0};
  const auto path = run(problem, 1e-5, {.output_times = at});
  ASSERT_EQ(path.times, at);
  const auto exact = [](double t) {
    const double half = std::floor(t / M_PI), centre = std::fmod(half, 2.0) == 0.0 ? 0.1 : -0.1;
    return centre + (0.9 - 0.2 * half) * std::cos(t);
  };
  expect_row(path, 0, exact, 1e-4);
}

TEST_P(AccuracyScheme, EndsBeforeABlowUp) {
  for (const double order : {0.5, 1.0}) {
    for (const auto& [accuracy, latest] : {std::pair{1e-3, 1.01}, {1e-8, 1.0 + 1e-7}}) {
      if (accuracy < 1e-3 && !is_spectral()) continue;
      const auto path = run(blow_up_problem(order), accuracy);
      EXPECT_NE(path.status, SolveStatus::finished) << order << ' ' << accuracy;
      EXPECT_LE(path.last_time, latest) << order << ' ' << accuracy;
      EXPECT_TRUE(path.y.allFinite());
    }
  }
}

// y y' = -1, y(0) = 1: y = sqrt(1 - 2t).
TEST_P(AccuracyScheme, EndsAtTheEdgeOfTheDomain) {
  Problem problem{
      .components = {{1.0, {1.0}}}, .rhs = [](double, In y, Out f) { f[0] = -1.0 / y[0]; }, .end = 2.0};
  problem.domain = {"y = 0", [](double, In y) { return y[0]; }};
  const auto path = run(problem, is_spectral() ? 1e-8 : 1e-4);
  EXPECT_NE(path.status, SolveStatus::finished);
  EXPECT_NEAR(path.last_time, 0.5, is_spectral() ? 1e-3 : 1e-2);
  if (is_spectral()) {
    EXPECT_EQ(path.status, SolveStatus::left_domain);
  }
}

// The same friction stops y where y' = 0 within |y| < 0.1, here at 5 pi: no solution exists after it.
TEST_P(AccuracyScheme, EndsWhereTheStateStaysOnASwitch) {
  const auto path = run(dry_friction(20.0), 1e-5);
  EXPECT_EQ(path.status, SolveStatus::sliding);
  EXPECT_NEAR(path.last_time, 5.0 * M_PI, 1e-3);
}

TEST_P(AccuracyScheme, EndsWithItsBudget) {
  Options options;
  options.budget = 0.0;
  const Scene scene = scene_of("brusselator");
  for (const double accuracy : {1e-8, 1e-12}) {
    EXPECT_EQ(GetParam()->solve(scene.problem, Tolerance{accuracy, accuracy}, options).status,
              SolveStatus::out_of_budget);
  }
}

TEST_P(AccuracyScheme, RefusesAGrid) {
  EXPECT_EQ(unsupported_reason(*GetParam(), half_order_relaxation(), Grid{1.0, 8}),
            "takes an accuracy, not a grid");
}

INSTANTIATE_TEST_SUITE_P(Schemes, AccuracyScheme, testing::ValuesIn(adaptive_schemes()), id_of_param);

}  // namespace
}  // namespace fde::bench
