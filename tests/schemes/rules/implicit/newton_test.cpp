// SPDX-License-Identifier: MIT
// Step equations for which plain Newton iteration diverges, or whose unknowns have unusual sizes.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class RobustNewton : public SchemeTest {};
INSTANTIATE_TEST_SUITE_P(, RobustNewton, testing::ValuesIn(implicit_schemes()), id_of_param);

// The concentrations jump where the solution of a step vanishes near the previous one.
TEST_P(RobustNewton, FollowsTheJumpsOfTheBrusselator) {
  const Problem problem = scene_of("brusselator").problem;
  for (int steps = 16; steps <= 1024; steps *= 2) {
    const auto path = run(problem, steps);
    EXPECT_EQ(path.status, SolveStatus::finished) << steps << ": " << path.last_time;
    EXPECT_LT(path.cost.newton_iterations, 40 * steps) << steps;
  }
}

// y = known + kappa y^3 with y(0) = 1 and such a large step has no solution near 1, and a negative one far
// away.
TEST_P(RobustNewton, DoesNotBeginFarFromTheStart) {
  const Problem cubic{.components = {{0.5, {1.0}}},
                      .rhs = [](double, In y, Out f) { f = y.array().cube().matrix(); },
                      .derivatives = DenseJacobian{
                          [](double, In y, OutMatrix jacobian) { jacobian(0, 0) = 3.0 * y[0] * y[0]; }}};
  const auto path = run(cubic, {1.0, 2});
  EXPECT_EQ(path.status, SolveStatus::step_too_large);
  EXPECT_EQ(path.last_time, 0.0);
  EXPECT_EQ(path.failure_time, 0.5);
  EXPECT_EQ(run(cubic, {0.01, 2}).status, SolveStatus::finished);
}

// For a smooth solution the extrapolated guess is nearly the solution.
TEST_P(RobustNewton, TakesLittleMoreThanOneIterationWhereAllIsSmooth) {
  constexpr int steps = 1 << 15;
  for (const auto* id : {"pendulum", "brusselator"}) {
    const Problem problem = scene_of(id).problem;
    EXPECT_LT(run(problem, steps).cost.newton_iterations, 1.3 * steps) << id;
  }
}

// In shorter steps the guess is mostly the solution, and f is known there.
TEST_P(RobustNewton, EvaluatesOnceAStepWhereAllIsSmooth) {
  constexpr int steps = 1 << 17;
  for (const auto* id : {"pendulum", "brusselator"}) {
    const Problem problem = scene_of(id).problem;
    if (unsupported_reason(*GetParam(), problem, Grid{problem.end, steps})) continue;
    const auto path = run(problem, steps);
    EXPECT_LT(path.cost.rhs_calls, 1.2 * steps) << id;
    EXPECT_LT(path.cost.newton_iterations, 0.5 * steps) << id;
  }
}

// y' = 1000 max(0, 1/2 - y) - 1/5 comes to rest at 0.4998. Extrapolated guesses go on below 1/2, and what a
// loose tolerance leaves of their equations must not add up.
TEST(GuessOfNewton, DoesNotAddUpWhatALooseToleranceAllows) {
  const Problem stopped{.components = {{1.0, {1.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = 1000.0 * std::max(0.0, 0.5 - y[0]) - 0.2; },
                        .end = 4.0};
  for (const auto* scheme : {"bdf2", "bdf3", "bdf5", "grunwald_letnikov"}) {
    const double end = solve(scheme, stopped, 50, {.newton_tolerance = 1e-2}).y(0, 50);
    EXPECT_NEAR(end, 0.4998, 1e-2) << scheme;
  }
}

// y' = 1 up to y(5) = 5, which solves all later steps. The extrapolated guess is 6, close to other solutions
// of the backward Euler step y = 5 + f(y): y = 6.1 with the cubic f, y = 6.06 with the square one, where 1 -
// f'(y) has another sign than at 5.
TEST(GuessOfNewton, DoesNotLeadToAnotherSolution) {
  const auto cubic = [](double y) { return -20.0 * (y - 5.0) * (y - 5.6) * (y - 6.2); };
  const auto square = [](double y) { return 100.0 * (y - 5.0) * (y - 6.05); };
  ASSERT_NEAR(6.1, 5.0 + cubic(6.1), 1e-12);
  ASSERT_NEAR(6.06, 5.0 + square(6.06), 1e-12);
  for (const std::function<double(double)>& later : {std::function(cubic), std::function(square)}) {
    const Problem problem{.components = {{1.0, {0.0}}},
                          .rhs = [&](double t, In y, Out f) { f[0] = t < 5.5 ? 1.0 : later(y[0]); },
                          .end = 8.0};
    for (const auto* id : {"l1", "grunwald_letnikov"}) {
      const auto path = find_scheme(id)->solve(problem, Grid{8.0, 8}, {});
      ASSERT_EQ(path.status, SolveStatus::finished) << id;
      for (const int n : {5, 6, 7, 8}) EXPECT_NEAR(path.y(0, n), 5.0, 1e-14) << id << n;
    }
  }
}

// y' = y^2, y = 1 / (1 - t), and the same with order 1/2: the step has no solution where y is too large. No
// run continues known the blow-up.
TEST_P(RobustNewton, DoesNotStepOverABlowUp) {
  for (const double order : {0.5, 1.0}) {
    const Problem problem{.components = {{order, {1.0}}},
                          .rhs = [](double, In y, Out f) { f = y.cwiseProduct(y); },
                          .end = 2.0};
    for (int steps = 2; steps <= 4096; steps *= 2) {
      const auto path = run(problem, steps);
      EXPECT_NE(path.status, SolveStatus::finished) << order << ' ' << steps;
      EXPECT_LE(path.last_time, 1.0) << order << ' ' << steps;
    }
  }
}

// Robertson's reaction in units of `unit`, whose second unknown is 1e-5 of the others, and whose equations
// are of degree 2.
Problem robertson(double unit, bool jacobian) {
  Problem problem{.components = {{0.9, {unit}}, {0.9, {0.0}}, {0.9, {0.0}}},
                  .rhs =
                      [=](double, In y, Out f) {
                        const double slow = 0.04 * y[0], back = 1e4 * (y[1] / unit) * y[2],
                                     fast = 3e7 * (y[1] / unit) * y[1];
                        f << -slow + back, slow - back - fast, fast;
                      },
                  .end = 40.0};
  if (jacobian) {
    problem.derivatives = DenseJacobian{[=](double, In y, OutMatrix j) {
      const double b = 1e4 * y[1] / unit, c = 1e4 * y[2] / unit, a = 6e7 * y[1] / unit;
      j << -0.04, c, b, 0.04, -c - a, -b, 0.0, a, 0.0;
    }};
  }
  return problem;
}

TEST_P(RobustNewton, SizesOfTheUnknownsDoNotMatter) {
  constexpr int steps = 64;
  const auto once = run(robertson(1.0, true), {40.0, steps});
  ASSERT_EQ(once.status, SolveStatus::finished);
  for (const double unit : {1e-150, 1.0, 1e150}) {
    for (const bool jacobian : {true, false}) {
      const auto path = run(robertson(unit, jacobian), {40.0, steps});
      ASSERT_EQ(path.status, SolveStatus::finished) << unit;
      EXPECT_LE(path.cost.newton_iterations, *once.cost.newton_iterations + steps / 2) << unit;
      for (int i = 0; i < 3; ++i) {  // the same relative accuracy for the small one
        const double size = once.y.row(i).cwiseAbs().maxCoeff();
        EXPECT_LT((path.y.row(i) / unit - once.y.row(i)).cwiseAbs().maxCoeff(), 1e-12 * size) << unit;
      }
    }
  }
}

}  // namespace
}  // namespace fde::bench
