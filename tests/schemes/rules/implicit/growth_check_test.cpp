// SPDX-License-Identifier: MIT
// Steps too large for a growing mode: known its pole an implicit rule returns finite, meaningless numbers.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/schemes/problem/scalar_equation.hpp"
#include "support/implicit_schemes.hpp"

namespace fde::bench {
namespace {

class OutrunGrowthOf : public testing::TestWithParam<const Scheme*> {};
INSTANTIATE_TEST_SUITE_P(, OutrunGrowthOf, testing::ValuesIn(implicit_schemes()), id_of_param);

Trajectory run(const Scheme& scheme, const Problem& problem, const Grid& grid) {
  return scheme.solve(problem, grid, {});
}

// The weight of the newest value, y_n = known + kappa f_n, with steps of length 1.
double newest_weight(const Scheme& scheme, double order) {
  if (scheme.id == "l1") return std::tgamma(2.0 - order);
  if (scheme.id == "grunwald_letnikov") return 1.0;
  return 1.0 / std::tgamma(order + 2.0);
}

// A step of D^g y = lambda y is a division by 1 - kappa lambda, which has a pole at kappa lambda = 1.
TEST_P(OutrunGrowthOf, OneEquationEndsBeyondThePoleOfItsStep) {
  for (const double order : {0.3, 0.7, 1.0}) {
    const double pole = 1.0 / newest_weight(*GetParam(), order);
    const auto ending = [&](double rate) {
      return run(*GetParam(), scalar_equation(order, rate, 16), {16.0, 16}).status;
    };
    EXPECT_EQ(ending(0.999 * pole), SolveStatus::finished) << order;
    EXPECT_EQ(ending(1.001 * pole), SolveStatus::step_too_large) << order;
    EXPECT_EQ(ending(1e9 * pole), SolveStatus::step_too_large) << order;
    EXPECT_EQ(ending(-1e9 * pole), SolveStatus::finished) << order;
  }
}

// A motion along a.v + b.w = C0 with a.b < 0 has the mode e^(st), a.a + a.b s^(alpha-1) = 0 for large s: at
// alpha = 1.5 it is s = (5/0.1)^2 = 2500 here, and e^(2500 t) overflows at t = 0.28.
TEST_P(OutrunGrowthOf, ConstrainedMotionsDoNotComeBackFromInfinity) {
  for (const auto* formulation : {"multiplier", "integrated"}) {
    const Problem problem =
        scene_of("fractional_constraint_2d", {{"alpha", 1.5}, {"formulation", formulation}}).problem;
    for (const int steps : {64, 512, 4096}) {
      for (const Grid& grid : grids_of(*GetParam(), problem.end, steps)) {
        const auto path = run(*GetParam(), problem, grid);
        EXPECT_TRUE(path.status == SolveStatus::step_too_large || path.status == SolveStatus::non_finite)
            << formulation << steps << ' ' << grid.grading << ' ' << static_cast<int>(path.status);
        EXPECT_LT(path.last_time, 0.4) << formulation << steps << ' ' << grid.grading;
      }
    }
  }
}

// On a graded grid later steps become too large: D^1 y = 40 y, h = 1/40 for backward Euler.
TEST(GrowthCheck, EndsAtTheFirstStepThatIsTooLong) {
  const Grid grid{1.0, 64, 2.0};
  const auto path = run(*find_scheme("l1"), scalar_equation(1.0, 40.0, 1), grid);
  ASSERT_EQ(path.status, SolveStatus::step_too_large);
  const int last = static_cast<int>(path.steps);
  EXPECT_LT(grid.step(last), 1.0 / 40.0);
  EXPECT_GT(grid.step(last + 1), 1.0 / 40.0);
  EXPECT_EQ(*path.failure_time, grid.time(last + 1));
}

// For a sparse matrix too, and for one mode among others: y_i' = rate_i y_i.
TEST(GrowthCheck, OneModeOfManyIsSeen) {
  for (const double rate : {50.0, 70.0, -70.0}) {
    SparseMatrix matrix(3, 3);
    matrix.insert(0, 0) = -1e6;
    matrix.insert(1, 1) = rate;
    matrix.insert(2, 2) = 0.5;
    const Problem problem{.components = {{1.0, {1.0}}, {1.0, {1.0}}, {1.0, {1.0}}},
                          .rhs = [matrix](double, In y, Out f) { f = matrix * y; },
                          .derivatives = SparseLinearPart{matrix}};
    EXPECT_EQ(run(*find_scheme("l1"), problem, {1.0, 64}).status,
              rate > 64.0 ? SolveStatus::step_too_large : SolveStatus::finished)
        << rate;
  }
}

// Oscillating growth and decay have no such pole: rates 100 (1 +- i) and -1000 with steps of 1.
TEST_P(OutrunGrowthOf, DecayAndOscillationsPass) {
  for (const double order : {0.5, 1.0}) {
    EXPECT_EQ(run(*GetParam(), scalar_equation(order, {100.0, 100.0}, 16), {16.0, 16}).status,
              SolveStatus::finished);
    EXPECT_EQ(run(*GetParam(), scalar_equation(order, -1000.0, 16), {16.0, 16}).status,
              SolveStatus::finished);
  }
}

}  // namespace
}  // namespace fde::bench
