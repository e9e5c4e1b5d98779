// SPDX-License-Identifier: MIT
// A right-hand side that jumps at a grid time: y is continuous, so its value there is that of the problem
// without the jump.

#include "fdebench/schemes/stepping/grid_jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fdebench/schemes/problem/chain.hpp"
#include "support/implicit_schemes.hpp"

namespace fde::bench {
namespace {

constexpr double end = 4.0, jump = 1.0;  // jump is a time of a uniform grid, and of one graded with 2

// 1 before the jump; at it f need not have a value.
double load(double t, bool jumps) {
  if (!jumps || t < jump) return 1.0;
  return t > jump ? -2.0 : std::numeric_limits<double>::quiet_NaN();
}

// D^g u = load - u - u^3, in multi-term form where the scheme takes that.
Problem problem_of(const Scheme& scheme, double order, bool jumps) {
  const auto force = [jumps](double t, In y) { return load(t, jumps) - y[0] - y[0] * y[0] * y[0]; };
  const std::vector<double> start(initial_count(order), 0.5);
  Problem problem = scheme.capabilities.discretises_equations
                        ? chain_problem({{.chain = Chain({1.0, order}, {}, start), .force = force}}, end)
                        : Problem{.components = {{order, start}},
                                  .rhs = [force](double t, In y, Out f) { f[0] = force(t, y); },
                                  .end = end};
  if (jumps) problem.jump_times = {jump};
  return problem;
}

double value_at(double t, const Scheme& scheme, const Problem& problem, const Grid& grid) {
  const auto path = scheme.solve(problem, grid, {.output_times = {t}});
  EXPECT_EQ(path.status, SolveStatus::finished) << scheme.id;
  return path.y.cols() == 1 ? path.y(0, 0) : std::nan("");
}

class GridJump : public testing::TestWithParam<const Scheme*> {};

TEST_P(GridJump, DoesNotChangeTheValueAtItsTime) {
  const Scheme& scheme = *GetParam();
  for (const double order : {0.25, 0.75, 1.0, 1.5}) {
    for (const Grid& grid : grids_of(scheme, end, 512)) {
      const Problem with = problem_of(scheme, order, true), without = problem_of(scheme, order, false);
      if (unsupported_reason(scheme, with, grid)) continue;
      EXPECT_NEAR(value_at(jump, scheme, with, grid), value_at(jump, scheme, without, grid), 1e-11)
          << order << ' ' << grid.grading;
    }
  }
}

// After the jump all schemes approach the same solution.
TEST_P(GridJump, IsFollowedByTheSolution) {
  const Scheme& scheme = *GetParam();
  for (const double order : {0.25, 0.75, 1.0, 1.5}) {
    const Problem problem = problem_of(scheme, order, true);
    if (unsupported_reason(scheme, problem, Grid{end, 512})) continue;
    const double expected =
        value_at(end, *find_scheme("product_trapezoidal"),
                 problem_of(*find_scheme("product_trapezoidal"), order, true), {end, 4096});
    EXPECT_NEAR(value_at(end, scheme, problem, {end, 512}), expected, 0.01) << order;
  }
}

// A grid time that is the time of the jump up to rounding, on either side of it.
TEST_P(GridJump, MayBeNextToItsGridTime) {
  const Scheme& scheme = *GetParam();
  const Grid grid{end, 512};
  const double expected = value_at(end, scheme, problem_of(scheme, 0.75, true), grid);
  for (const double side : {-1e-15, 1e-15}) {
    Problem moved = problem_of(scheme, 0.75, true);
    moved.jump_times = {jump + side};
    EXPECT_NEAR(value_at(end, scheme, moved, grid), expected, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(, GridJump, testing::ValuesIn(grid_schemes()), id_of_param);

// 0 = u - load, D^g w = u: an algebraic unknown has its value of the left side.
TEST(JumpAtAGridTime, LeavesAnAlgebraicUnknownOnItsLeftSide) {
  const Problem problem{.components = {{0.6, {0.0}}, {0.0, {1.0}}},
                        .rhs = [](double t, In y, Out f) { f << y[1], y[1] - load(t, true); },
                        .end = end,
                        .jump_times = {jump}};
  const double exact = 1.0 / std::tgamma(1.6);
  for (const auto* scheme : implicit_schemes()) {
    const auto path = scheme->solve(problem, Grid{end, 512}, {.output_times = {jump}});
    ASSERT_EQ(path.status, SolveStatus::finished) << scheme->id;
    EXPECT_EQ(path.y(1, 0), 1.0) << scheme->id;
    EXPECT_NEAR(path.y(0, 0), exact, 0.01) << scheme->id;
  }
}

// D^0.2 y = step(1 - t) - y: y(1) = 1 - E_0.2(-1) = 0.528899311066517 (`fdebench exact`; in 40 digits by
// Talbot's contour too).
TEST(JumpAtAGridTime, OfASmallOrderHasItsClosedForm) {
  const Problem problem{.components = {{0.2, {0.0}}},
                        .rhs =
                            [](double t, In y, Out f) {
                              f[0] = (t < 1.0 ? 1.0 : t > 1.0 ? 0.0 : 0.5) - y[0];
                            },
                        .derivatives = DenseLinearPart{Matrix::Constant(1, 1, -1.0)},
                        .end = 2.0,
                        .jump_times = {1.0}};
  const Scheme& scheme = *find_scheme("product_trapezoidal");
  EXPECT_NEAR(value_at(1.0, scheme, problem, {2.0, 20000}), 0.528899311066517, 1e-6);
}

}  // namespace
}  // namespace fde::bench
