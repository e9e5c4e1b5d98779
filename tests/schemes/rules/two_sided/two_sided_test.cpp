// SPDX-License-Identifier: MIT
// Problems with right derivatives or conditions at both ends, solved at all times at once.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/benchmarks/scenes/two_sided/manufactured_problem.hpp"
#include "fdebench/schemes/rules/two_sided/global_solver.hpp"
#include "support/scheme_test.hpp"
#include "support/testing.hpp"
#include "support/two_sided_problems.hpp"

namespace fde::bench {
namespace {

std::vector<const Scheme*> two_sided_schemes() {
  auto some = grid_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->capabilities.is_two_sided; });
  return some;
}

const WeightFamily& family_of(const Scheme& scheme) {
  return scheme.id == "grunwald_letnikov" ? families::grunwald_letnikov : families::trapezoid;
}

class TwoSided : public SchemeTest {
 protected:
  static Trajectory run(const Problem& problem, int steps, const Options& options = {}) {
    auto path = SchemeTest::run(problem, steps, options);
    EXPECT_EQ(path.status, SolveStatus::finished);
    EXPECT_EQ(path.last_time, problem.end);
    EXPECT_EQ(path.steps, steps);
    return path;
  }

  // Largest error of any component at these fractions of the interval.
  static Fit fit(const ManufacturedProblem& made, const std::vector<double>& fractions) {
    std::vector<ErrorSample> errors;
    for (int steps = 128; steps <= 2048; steps *= 2) {
      Options options;
      for (const double fraction : fractions) options.output_times.push_back(fraction * made.problem.end);
      const auto path = run(made.problem, steps, options);
      double error = 0.0;
      for (Eigen::Index c = 0; c < path.y.cols(); ++c) {
        const Vec off = path.y.col(c) - made.exact(path.time(c));
        error = std::max(error, off.cwiseAbs().maxCoeff());
      }
      errors.push_back({made.problem.end / steps, error});
    }
    return fit_rate(errors);
  }
};

TEST_P(TwoSided, SmoothSolutionsShowTheRate) {
  const ManufacturedProblem made = smooth_two_sided();
  const double expected = GetParam()->expected_rate(made.problem, made.smoothness, 1.0, Norm::end);
  EXPECT_EQ(expected, GetParam()->id == "grunwald_letnikov" ? 1.0 : 2.0);
  const auto observed = fit(made, {0.0, 0.25, 0.5, 0.75, 1.0});
  EXPECT_EQ(observed.points, 5U);
  EXPECT_NEAR(observed.slope, expected, 0.1);
  EXPECT_GT(observed.correlation, 0.999);
}

// The right row starts like (T - t)^0.9 with order 0.5, f like (T - t)^0.4.
TEST_P(TwoSided, ARightRowCostsWhatItsStartCosts) {
  const ManufacturedProblem made =
      manufactured_problem({{0.7, 3.0, Side::left}, {0.5, 0.9, Side::right}}, 1.0);
  const double expected = GetParam()->expected_rate(made.problem, made.smoothness, 1.0, Norm::end);
  EXPECT_NEAR(expected, GetParam()->id == "grunwald_letnikov" ? 1.0 : 1.4, 1e-12);
  EXPECT_NEAR(fit(made, {0.25, 0.5, 0.75}).slope, expected, 0.1);
}

// (T - t)^0.9 has an error h^0.9 in the first step of its row, the last of the grid.
TEST_P(TwoSided, TheWorstErrorIsInTheFirstStepOfARightRow) {
  const ManufacturedProblem made =
      manufactured_problem({{0.7, 3.0, Side::left}, {0.5, 0.9, Side::right}}, 1.0);
  const auto rate = [&](Norm norm) {
    return GetParam()->expected_rate(made.problem, made.smoothness, 1.0, norm);
  };
  EXPECT_NEAR(rate(Norm::maximum), 0.9, 1e-12);
  std::vector<ErrorSample> errors;
  for (int steps = 128; steps <= 2048; steps *= 2) {
    const Grid grid{made.problem.end, steps};
    const auto path = run(made.problem, steps, {.output_times = {grid.time(steps - 1)}});
    const Vec off = path.y.col(0) - made.exact(path.times[0]);
    errors.push_back({grid.step(), off.cwiseAbs().maxCoeff()});
  }
  EXPECT_NEAR(fit_rate(errors).slope, rate(Norm::maximum), 0.1);
}

// With time reversed, left rows are right rows.
TEST_P(TwoSided, TheMirroredProblemHasTheMirroredSolution) {
  const ManufacturedProblem made = smooth_two_sided();
  const Rows y = run(made.problem, 256).y, back = run(mirrored(made.problem), 256).y.rowwise().reverse();
  EXPECT_LT((y - back).cwiseAbs().maxCoeff(), 1e-12);
}

// But at a jump, where stepping delivers the value of the step before it.
TEST_P(TwoSided, WithoutRightRowsTheSolutionIsThatOfStepping) {
  for (const auto* id : {"pendulum", "brusselator", "bagley_torvik"}) {
    const auto scene = scene_of(id);
    const double end = std::min(scene.problem.end, 5.0);
    const Grid grid{.end = end, .steps = 700};
    Rows marched = GetParam()->solve(scene.problem, grid, {}).y;
    const auto path = solve_globally(scene.problem, grid, {}, family_of(*GetParam()));
    ASSERT_EQ(path.status, SolveStatus::finished) << id;
    for (const double jump : scene.problem.jump_times)
      if (jump < end) marched.col(grid.nearest_index(jump)) = path.y.col(grid.nearest_index(jump));
    EXPECT_LT((path.y - marched).cwiseAbs().maxCoeff(), 1e-12 * marched.cwiseAbs().maxCoeff()) << id;
  }
}

TEST_P(TwoSided, PermutingComponentsPermutesTheAnswer) {
  const ManufacturedProblem made = smooth_two_sided();
  const std::vector<Eigen::Index> order{3, 5, 0, 1, 4, 2};
  Problem permuted{.end = made.problem.end};
  for (const auto i : order)
    permuted.components.push_back(made.problem.components[static_cast<std::size_t>(i)]);
  permuted.rhs = [&](double t, In y, Out f) {
    Vec back(6), g(6);
    back(order) = y;
    made.problem.rhs(t, back, g);
    f = g(order);
  };
  const Rows straight = run(made.problem, 100).y;
  EXPECT_LT((run(permuted, 100).y - Rows(straight(order, Eigen::all))).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(TwoSided, EnginesAndJacobiansAgree) {
  const ManufacturedProblem made =
      manufactured_problem({{0.7, 3.0, Side::left}, {0.5, 2.0, Side::right}}, 2.0);
  Problem with_jacobian = made.problem;
  with_jacobian.derivatives = DenseJacobian{[](double, In y, OutMatrix jacobian) {
    const auto row = [&](Eigen::Index i) {
      jacobian(i, i) = std::sin(y[1 - i]) / 2 - 1.0;
      jacobian(i, 1 - i) = std::cos(y[1 - i]) * y[i] / 2;
    };
    row(0);
    row(1);
  }};
  const auto direct = run(made.problem, 500, {.history = HistoryKind::direct});
  const auto exponentials = run(with_jacobian, 500, {.history = HistoryKind::exponentials});
  EXPECT_LT((direct.y - exponentials.y).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT(exponentials.cost.rhs_calls, direct.cost.rhs_calls);
}

TEST_P(TwoSided, CallsAreCountedAndStepsObservedInOrder) {
  const ManufacturedProblem made = smooth_two_sided();
  std::int64_t calls = 0;
  Problem problem = made.problem;
  problem.rhs = [&](double t, In y, Out f) {
    ++calls;
    made.problem.rhs(t, y, f);
  };
  const Grid grid{problem.end, 40};
  const std::vector<int> places{0, 7, 40};
  std::vector<double> heard;
  Options options{.observer = [&](double t, In /*y*/) { heard.push_back(t); }};
  for (const int n : places) options.output_times.push_back(grid.time(n));
  const auto path = run(problem, 40, options);
  EXPECT_EQ(path.cost.rhs_calls, calls);
  EXPECT_GT(path.cost.newton_iterations, 1);
  EXPECT_EQ(path.times, options.output_times);
  ASSERT_EQ(heard.size(), 41U);
  for (int n = 0; n <= 40; ++n) EXPECT_EQ(heard[static_cast<std::size_t>(n)], grid.time(n));
  EXPECT_EQ(path.y, Rows(run(problem, 40).y(Eigen::all, places)));
}

// y = known + kappa (1e6 + y^2) has no real solution.
TEST_P(TwoSided, AnImpossibleProblemIsAnOutcome) {
  const Problem problem{.components = {{0.5, {0.0}}, {0.5, {0.25}, Side::right}},
                        .rhs = [](double, In y, Out f) { f << 1e6 + y[0] * y[0], y[0]; }};
  const auto path = GetParam()->solve(problem, Grid{1.0, 16}, {});
  EXPECT_EQ(path.status, SolveStatus::not_converged);
  EXPECT_EQ(path.last_time, 0.0);
  EXPECT_EQ(path.failure_time, std::nullopt);
  EXPECT_GT(path.residual, 1.0);
  EXPECT_EQ(path.times, std::vector<double>{0.0});
  EXPECT_EQ(path.y, (Rows(2, 1) << 0.0, 0.25).finished());
}

INSTANTIATE_TEST_SUITE_P(, TwoSided, testing::ValuesIn(two_sided_schemes()), id_of_param);

}  // namespace
}  // namespace fde::bench
