// SPDX-License-Identifier: MIT
// Sparse Jacobians with adaptive step size: the results of dense ones, by sparse linear solvers.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct SparseCase {
  std::string name, method;
  Problem problem;
  SparseMatrix matrix;  // of the linear part
};

Problem problem_of(const SparseMatrix& matrix, double order, double cubic) {
  const auto size = static_cast<std::size_t>(matrix.rows());
  Problem problem{.components = {}, .rhs = {}, .end = 1.0};
  for (std::size_t i = 0; i < size; ++i) {
    const double start = std::sin(1.0 + static_cast<double>(i));
    problem.components.push_back({order, order > 1.0 ? std::vector{start, 0.0} : std::vector{start}});
  }
  problem.rhs = [matrix, cubic](double, In y, Out f) { f = matrix * y - cubic * y.array().cube().matrix(); };
  return problem;
}

std::vector<SparseCase> sparse_cases() {
  const auto square =
      std::get<SparseLinearPart>(scene_of("fractional_diffusion_2d", {{"n", 6.0}}).problem.derivatives)
          .matrix;
  const auto line =
      std::get<SparseLinearPart>(scene_of("fractional_diffusion", {{"components", 20.0}}).problem.derivatives)
          .matrix;
  SparseMatrix ring = line;
  ring.coeffRef(0, 19) = ring.coeffRef(19, 0) = 441.0;
  ring.makeCompressed();
  const auto of = [](std::string name, std::string method, const SparseMatrix& matrix, double order) {
    return SparseCase{std::move(name), std::move(method), problem_of(matrix, order, 0.0), matrix};
  };
  return {of("line", "tridiagonal", line, 0.5), of("square", "fast_sine", square, 0.5),
          of("classical", "fast_sine", square, 1.0), of("ring", "lu", ring, 0.3),
          of("wave", "lu", square, 1.5)};
}

class SparseStages : public testing::TestWithParam<SparseCase> {};
INSTANTIATE_TEST_SUITE_P(, SparseStages, testing::ValuesIn(sparse_cases()), name_of_param);

Trajectory solved(const Problem& problem) {
  auto path = find_scheme("radau_exponentials")
                  ->solve(problem, Tolerance{1e-6, 1e-6}, {.output_times = {0.01, 0.3, 1.0}});
  EXPECT_EQ(path.status, SolveStatus::finished);
  return path;
}

TEST_P(SparseStages, OfALinearProblemAreTheDenseOnes) {
  Problem dense = GetParam().problem, sparse = dense;
  dense.derivatives = DenseLinearPart{Matrix(GetParam().matrix)};
  sparse.derivatives = SparseLinearPart{GetParam().matrix};
  const auto few = solved(sparse);
  EXPECT_LT((few.y - solved(dense).y).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_EQ(few.cost.linear_solver, GetParam().method);
}

TEST_P(SparseStages, OfANonlinearProblemAreTheDenseOnes) {
  const auto& matrix = GetParam().matrix;
  Problem dense = problem_of(matrix, GetParam().problem.components.front().order, 2.0), sparse = dense;
  dense.derivatives = DenseJacobian{[=](double, In y, OutMatrix j) {
    j = matrix;
    j.diagonal() -= (6.0 * y.array().square()).matrix();
  }};
  sparse.derivatives = SparseJacobian{[=](double, In y, SparseMatrix& j) {
    j = matrix;
    j.diagonal() -= (6.0 * y.array().square()).matrix();
  }};
  EXPECT_LT((solved(sparse).y - solved(dense).y).cwiseAbs().maxCoeff(), 1e-10);
}

// Tolerance 1e-9 on a line of 200 points: 1608 steps.
TEST(SparseSteps, DeliverASmallAccuracyOfAStiffProblem) {
  const Scene scene = scene_of("fractional_diffusion", {});
  const auto path = find_scheme("radau_exponentials")
                        ->solve(scene.problem, Tolerance{1e-9, 1e-9}, {.output_times = {0.001, 0.1, 1.0}});
  ASSERT_EQ(path.status, SolveStatus::finished);
  for (const Eigen::Index column : {0, 1, 2}) {
    const auto exact = scene.reference.at(path.time(column));
    EXPECT_LT((path.y.col(column) - exact.value).cwiseAbs().maxCoeff(), 1e-10) << path.time(column);
  }
}

// Far from the step u is below 1e-292 at first, where doubles lose the digits that an error estimate needs.
TEST(SparseSteps, PassAStartThatJumpsInSpace) {
  const Scene scene = make_scene(parse_variant("fractional_diffusion:start=step"));
  const auto path = find_scheme("radau_exponentials")
                        ->solve(scene.problem, Tolerance{1e-4, 1e-4}, {.output_times = {1e-6, 1e-3, 1.0}});
  ASSERT_EQ(path.status, SolveStatus::finished);
  for (const Eigen::Index column : {0, 1, 2}) {
    const auto exact = scene.reference.at(path.time(column));
    EXPECT_LT((path.y.col(column) - exact.value).cwiseAbs().maxCoeff(), 1e-4) << path.time(column);
  }
}

TEST(SparseSteps, OfTheTrapezoidalRuleReportTheLinearSolver) {
  const Scene scene = scene_of("fractional_diffusion_2d", {{"n", 6.0}});
  const auto path = find_scheme("adaptive_trapezoidal")
                        ->solve(scene.problem, Tolerance{1e-3, 1e-3}, {.output_times = {1.0}});
  EXPECT_EQ(path.cost.linear_solver, "fast_sine");
}

}  // namespace
}  // namespace fde::bench
