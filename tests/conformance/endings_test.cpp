// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

const SceneFactory& factory(std::string_view id) { return *find_scene(id); }

// A mass on a vertical spring that is released far out passes through its point of suspension: the angle is
// not defined there, while every formula remains finite.
class Singularity : public testing::TestWithParam<const Scheme*> {};

TEST_P(Singularity, EndsTheRunWithStepAndTime) {
  Scene scene = make_scene(factory("extensible_pendulum"),
                           {{"phi0", 0.0}, {"xi0", 3.0}, {"K_over_m", 5.0}, {"g_over_L", 0.1}});
  const auto path = GetParam()->solve(scene.problem, Grid{scene.problem.end, 4096}, {});
  ASSERT_EQ(path.status, SolveStatus::left_domain);
  EXPECT_EQ(describe(scene.problem, path).find("ran into the singularity r = L (1 + xi) = 0 at step 1"), 0U)
      << describe(scene.problem, path);
  EXPECT_GT(scene.problem.domain.margin(0.0, path.y.rightCols(1)), 0.0);
}

INSTANTIATE_TEST_SUITE_P(, Singularity,
                         testing::Values(find_scheme("adams_pc"), find_scheme("l1"),
                                         find_scheme("grunwald_letnikov"), find_scheme("product_trapezoidal"),
                                         find_scheme("decoupled_multi_order")),
                         id_of_param);

// Backward Euler damps the free pendulum by 5 % a step, to below the smallest doubles.
TEST(Underflow, IsNoFailureOfNewtonsMethod) {
  Scene scene = make_scene(factory("pendulum"), {{"mu", 0.0}, {"nu", 0.0}, {"lambda", 0.0}});
  const auto path = solve("l1", scene.problem, Grid{4e3, 10000}, {.output_times = {4e3}});
  EXPECT_EQ(path.status, SolveStatus::finished) << describe(scene.problem, path);
  EXPECT_LT(path.y.cwiseAbs().maxCoeff(), 1e-290);
}

TEST(Examination, TellsStopsAtASingularityFromWrongOnesAndFromNone) {
  const auto ending = [](const ParameterValues& values, double until, std::string_view scheme, int steps) {
    const Scene scene =
        make_scene({.factory = &factory("extensible_pendulum"), .values = values, .until = until});
    MemoizedReference reference(scene);
    return examine({}, scene, reference, *find_scheme(scheme), {steps}).ending.kind;
  };
  const ParameterValues falls{{"phi0", 0.0}, {"xi0", 3.0}, {"K_over_m", 5.0}, {"g_over_L", 0.1}};
  EXPECT_EQ(ending(falls, 2.0, "l1", 1024), SolveStatus::left_domain);
  EXPECT_EQ(ending(falls, 2.0, "l1", 1), SolveStatus::step_too_large);
  EXPECT_EQ(ending(falls, 2.0, "adams_pc", 1), Verdict::passed_singularity);
  EXPECT_EQ(ending({{"K_over_m", 1e4}}, 1.0, "adams_pc", 100), Verdict::false_singularity);
}

class Budget : public testing::TestWithParam<const Scheme*> {};

TEST_P(Budget, OfNoTimeEndsTheRun) {
  const Scene scene = make_scene(factory("relaxation"));
  const auto path = GetParam()->solve(scene.problem, Grid{1.0, 1000}, {.budget = 0.0});
  EXPECT_EQ(path.status, SolveStatus::out_of_budget);
  EXPECT_LT(path.steps, 100);
  EXPECT_NE(describe(scene.problem, path).find("out of its budget of time at step"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(, Budget,
                         testing::Values(find_scheme("adams_pc"), find_scheme("l1"),
                                         find_scheme("grunwald_letnikov"), find_scheme("product_trapezoidal"),
                                         find_scheme("decoupled_multi_order"),
                                         find_scheme("commensurate_adams_pc")),
                         id_of_param);

TEST(BudgetOfShortRuns, IsLookedAtToo) {
  const Scene scene = make_scene(factory("relaxation"));
  EXPECT_EQ(solve("l1", scene.problem, Grid{1.0, 2}, {.budget = 0.0}).status, SolveStatus::out_of_budget);
}

TEST(BudgetOfTwoSided, EndsNewtonsMethod) {
  const Scene scene = make_scene(factory("fractional_hamilton"));
  const auto path = solve("product_trapezoidal", scene.problem, 64, {.budget = 0.0});
  EXPECT_EQ(path.status, SolveStatus::out_of_budget);
}

}  // namespace
}  // namespace fde::bench
