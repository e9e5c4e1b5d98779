// SPDX-License-Identifier: MIT
// A run that is ended between two steps and continued from its state returns the bits of an uninterrupted
// run.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "schemes/stepping/interrupted.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

std::vector<const Scheme*> keeping_schemes() {
  auto some = all_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->capabilities.checkpoints; });
  return some;
}

// The bits of the values, so that NaN equals itself and -0 differs from 0.
std::vector<std::uint64_t> bits(const Matrix& values) {
  std::vector<std::uint64_t> found;
  for (const double value : values.reshaped()) found.push_back(std::bit_cast<std::uint64_t>(value));
  return found;
}

void expect_same(const Trajectory& continued, const Trajectory& whole, const std::string& what) {
  EXPECT_EQ(continued.status, whole.status) << what;
  EXPECT_EQ(continued.times, whole.times) << what;
  EXPECT_EQ(bits(continued.y), bits(whole.y)) << what;
  EXPECT_EQ(continued.last_time, whole.last_time) << what;
  EXPECT_EQ(continued.steps, whole.steps) << what;
  EXPECT_EQ(continued.cost.rhs_calls, whole.cost.rhs_calls) << what;
  EXPECT_EQ(continued.cost.newton_iterations, whole.cost.newton_iterations) << what;
  EXPECT_EQ(continued.cost.rejected_steps, whole.cost.rejected_steps) << what;
  EXPECT_EQ(continued.cost.linear_solver, whole.cost.linear_solver) << what;
  ASSERT_EQ(bool(continued.dense_output), bool(whole.dense_output)) << what;
  if (!whole.dense_output) return;
  for (const double part : {0.1, 0.77, 1.0}) {
    EXPECT_EQ(bits(continued.dense_output(part * whole.last_time)),
              bits(whole.dense_output(part * whole.last_time)))
        << what;
  }
}

// Runs that end at the n-th offered state for each n of `ends`, each continued from the state of the one
// before; the last one continues to the end.
Trajectory interrupted(const Scheme& scheme, const Problem& problem, const Resolution& resolution,
                       Options options, const std::vector<int>& ends) {
  std::string kept;
  for (const int n : ends) {
    InterruptingCheckpoints checkpoints(n, kept);
    options.checkpoints = &checkpoints;
    try {
      auto path = scheme.solve(problem, resolution, options);
      EXPECT_GT(n, 1) << "no state is offered before a step";
      return path;
    } catch (const RunInterrupted&) {
      kept = checkpoints.saved_state();
      EXPECT_FALSE(kept.empty());
    }
  }
  InterruptingCheckpoints checkpoints(0, kept);
  options.checkpoints = &checkpoints;
  return scheme.solve(problem, resolution, options);
}

class ContinuedRuns : public testing::TestWithParam<const Scheme*> {
 protected:
  static const Scheme& scheme() { return *GetParam(); }

  // Interrupted at the start, next to the end of a block of the exponentials, and far from it.
  static void expect_same_bits(const Problem& problem, const Resolution& resolution, const Options& options,
                               const std::string& what) {
    if (unsupported_reason(scheme(), problem, resolution) ||
        unsupported_checkpoints_reason(scheme(), problem))
      return;
    const auto whole = scheme().solve(problem, resolution, options);
    for (const auto& ends : std::vector<std::vector<int>>{{1}, {2, 2, 3, 5}, {33, 2}, {50}})
      expect_same(interrupted(scheme(), problem, resolution, options, ends), whole, what);
  }

  // On grids with both kinds of history, and with a tolerance.
  static void expect_same_bits(const Problem& problem, const std::string& what) {
    for (const double grading : {1.0, 1.5}) {
      for (const auto history : {HistoryKind::direct, HistoryKind::exponentials}) {
        expect_same_bits(problem, Grid{problem.end, 75, grading}, {.history = history},
                         fmt::format("{}, grading {}, {}", what, grading, name(history)));
      }
    }
    expect_same_bits(problem, Tolerance{1e-3, 1e-3}, {}, what + ", 1e-3");
    expect_same_bits(problem, Tolerance{1e-3, 1e-3}, {.output_times = {0.2 * problem.end, 0.9 * problem.end}},
                     what + ", 1e-3 at two times");
  }
  static void expect_same_bits(const std::string& scene) {
    expect_same_bits(make_scene(read_variant(scene, {})).problem, scene);
  }
};

INSTANTIATE_TEST_SUITE_P(, ContinuedRuns, testing::ValuesIn(keeping_schemes()), id_of_param);

TEST_P(ContinuedRuns, OfOneEquation) {
  expect_same_bits("relaxation");
  expect_same_bits("diethelm");
}

TEST_P(ContinuedRuns, OfSeveralOrders) {
  expect_same_bits("brusselator");
  expect_same_bits("pendulum:until=3");
}

TEST_P(ContinuedRuns, OfTermsAndJumps) { expect_same_bits("bagley_torvik"); }

TEST_P(ContinuedRuns, OfConstraintsWithMultipliers) {
  expect_same_bits("knife_edge");
  expect_same_bits("knife_edge:formulation=multiplier");
  expect_same_bits("fractional_constraint_2d:until=2");
}

// The results before the checkpoint are the past after it.
TEST_P(ContinuedRuns, OfDelays) {
  const auto rhs = [](double t, In y, const Past& past, Out f) {
    past(t - 0.07, f);
    f[0] = y[0] * (1.0 - f[0]);
  };
  for (const double order : {0.9, 1.3}) {
    std::vector<double> initial(initial_count(order), 0.1);
    expect_same_bits({.components = {{order, initial}},
                      .delays = {.lags = {0.07}, .before = [](double, Out y) { y[0] = 0.1; }, .rhs = rhs}},
                     fmt::format("a delay, order {}", order));
  }
}

TEST_P(ContinuedRuns, OfManyUnknowns) {
  expect_same_bits("fractional_diffusion:components=70,diffusivity=1e-4");
  expect_same_bits("fractional_diffusion_2d:n=9,diffusivity=1e-3");
}

// D^(1/2) y = A(t) y - y^3 with large skew-symmetric couplings of neighbours until t = 0.1: the tridiagonal
// method is not applicable to the first matrices, and the method that replaces it is kept for the others.
Problem pushing_neighbours() {
  constexpr int size = 8;
  const auto matrix = [](double t) {
    std::vector<Eigen::Triplet<double>> entries;
    const double push = t < 0.1 ? 100.0 : 0.1;
    for (int i = 0; i < size; ++i) {
      entries.emplace_back(i, i, -1.0 - 0.1 * i);
      if (i > 0) entries.emplace_back(i, i - 1, push);
      if (i + 1 < size) entries.emplace_back(i, i + 1, -push);
    }
    SparseMatrix a(size, size);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
  };
  Problem problem{.components = std::vector<Component>(size, {0.5, {1.0}}),
                  .rhs = [=](double t, In y, Out f) { f = matrix(t) * y - y.array().cube().matrix(); },
                  .derivatives = SparseJacobian{[=](double t, In y, SparseMatrix& jacobian) {
                    SparseMatrix cubes(size, size);
                    cubes.setIdentity();
                    cubes.diagonal() = 3.0 * y.array().square();
                    jacobian = matrix(t) - cubes;
                  }},
                  .end = 1.0};
  return problem;
}

TEST_P(ContinuedRuns, OfSparseEquationsThatChangeTheirMethod) {
  expect_same_bits(pushing_neighbours(), "pushing neighbours");
}

// All solves with one matrix share the budget of iterations of conjugate gradients, the cost of factors: the
// iterations spent are part of the state, and so is which of the two methods solves.
TEST(ContinuedRunsOfConjugateGradients, GoOnWithWhatIsSpent) {
  const Problem problem =
      make_scene(parse_variant("fractional_diffusion_2d:n=50,medium=wave,contrast=1.5")).problem;
  const Scheme& rule = *find_scheme("l1");
  const Grid grid{problem.end, 8};
  const auto whole = rule.solve(problem, grid, {});
  EXPECT_EQ(whole.cost.linear_solver, "cholesky");
  for (const int n : {2, 3, 4, 6})
    expect_same(interrupted(rule, problem, grid, {}, {n}), whole, fmt::format("state {}", n));
}

TEST_P(ContinuedRuns, ReturnTheTimesAskedFor) {
  const Problem problem = scene_of("relaxation").problem;
  const Grid grid{problem.end, 75};
  if (unsupported_reason(scheme(), problem, grid)) GTEST_SKIP();
  const Options options{.output_times = {grid.time(1), grid.time(20), grid.time(74)}};
  const auto whole = scheme().solve(problem, grid, options);
  for (const int n : {2, 20, 21, 22, 75})
    expect_same(interrupted(scheme(), problem, grid, options, {n}), whole, fmt::format("state {}", n));
}

TEST_P(ContinuedRuns, TakeNoStateOfOtherUnknowns) {
  const Problem one = scene_of("relaxation").problem, two = scene_of("relaxation_pair").problem;
  const Grid grid{one.end, 75};
  if (unsupported_reason(scheme(), one, grid)) GTEST_SKIP();
  InterruptingCheckpoints first(40);
  EXPECT_THROW(scheme().solve(one, grid, {.checkpoints = &first}), RunInterrupted);
  InterruptingCheckpoints other(0, first.saved_state()),
      cut(0, first.saved_state().substr(0, first.saved_state().size() - 1));
  if (!unsupported_reason(scheme(), two, grid)) {
    EXPECT_THROW(scheme().solve(two, grid, {.checkpoints = &other}), std::invalid_argument);
  }
  EXPECT_THROW(scheme().solve(one, grid, {.checkpoints = &cut}), std::invalid_argument);
  InterruptingCheckpoints more(0, first.saved_state() + "more");
  EXPECT_THROW(scheme().solve(one, grid, {.checkpoints = &more}), std::invalid_argument);
}

// Enough unknowns for several threads, whose number may change where a run is continued.
TEST(ContinuedRunsOfManyThreads, AreThoseOfOne) {
  const Problem problem = make_scene(read_variant("fractional_diffusion:components=20000", {})).problem;
  const Scheme& scheme = *find_scheme("l1");
  const Grid grid{problem.end, 48};
  const Options options{.history = HistoryKind::exponentials, .output_times = {grid.time(20), problem.end}};
  const auto whole = scheme.solve(problem, grid, options);
  Options of_two = options;
  of_two.threads = 2;
  expect_same(interrupted(scheme, problem, grid, of_two, {30, 5}), whole, "two threads");
  InterruptingCheckpoints first(40);
  of_two.checkpoints = &first;
  EXPECT_THROW(scheme.solve(problem, grid, of_two), RunInterrupted);
  InterruptingCheckpoints second(0, first.saved_state());
  Options of_one = options;
  of_one.checkpoints = &second;
  expect_same(scheme.solve(problem, grid, of_one), whole, "two threads, then one");
}

TEST(CheckpointStore, AreRefusedWhereAllTimesAreSolvedAtOnce) {
  const Scheme& scheme = *find_scheme("grunwald_letnikov");
  EXPECT_EQ(unsupported_checkpoints_reason(scheme, scene_of("relaxation").problem), std::nullopt);
  EXPECT_NE(unsupported_checkpoints_reason(scheme, scene_of("two_sided_constraint").problem), std::nullopt);
}

}  // namespace
}  // namespace fde::bench
