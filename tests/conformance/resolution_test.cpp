// SPDX-License-Identifier: MIT
// Resolutions (grid or tolerance), and output times in place of steps.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/run.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// D^order y = -y, y(0) = 1.
Problem decay(double order) {
  return {.components = {{order, std::vector<double>(initial_count(order), 1.0)}},
          .rhs = [](double, In y, Out f) { f = -y; },
          .end = 2.0};
}

// Euler's method for order 1; the step from y keeps its error h^2 |y| / 2 at the tolerance.
Trajectory adaptive_euler(const Problem& problem, const Resolution& resolution, const Options& options) {
  const auto [relative, absolute] = std::get<Tolerance>(resolution);
  fde::Run run(problem, options);
  Vec y = run.start();
  for (double t = 0.0, h = 0.0; t < problem.end; t += h) {
    h = std::min(std::sqrt(2 * (relative + absolute / y.norm())), problem.end - t);
    y += h * run.rhs(t, y);
    if (!run.accept(t + h, y)) break;
  }
  return run.finish();
}

Scheme adaptive() {
  return {.id = "adaptive_euler",
          .title = "Adaptive Euler",
          .source = "",
          .capabilities = {.resolution = ResolutionKind::tolerance, .max_order = 1.0},
          .solve = adaptive_euler};
}

TEST(Resolution, ASchemeOnAGridRefusesAnAccuracy) {
  for (const auto& scheme : schemes()) {
    if (scheme.capabilities.is_adaptive()) continue;
    EXPECT_EQ(unsupported_reason(scheme, decay(1.0), Tolerance{1e-6, 1e-9}), "takes a grid, not an accuracy");
  }
}

TEST(Resolution, ASchemeThatChoosesItsTimesRefusesAGrid) {
  EXPECT_EQ(unsupported_reason(adaptive(), decay(1.0), Grid{2.0, 8}), "takes an accuracy, not a grid");
  EXPECT_EQ(unsupported_reason(adaptive(), decay(1.0), Tolerance{1e-3, 0.0}), std::nullopt);
  EXPECT_EQ(unsupported_reason(adaptive(), decay(1.0), Tolerance{0.0, 0.0}),
            "needs an accuracy above 0, not 0 relative and 0 absolute");
}

TEST(Refusal, OfASchemeThatDiscretisesEquationsNamesThem) {
  const Scheme direct{.id = "direct",
                      .title = "A direct multi-term rule",
                      .source = "",
                      .capabilities = {.discretises_equations = true},
                      .solve = {}};
  EXPECT_EQ(unsupported_reason(direct, decay(0.5), Grid{2.0, 8}),
            "discretises multi-term equations, and the problem is not given in multi-term form");
  EXPECT_EQ(unsupported_reason(direct, scene_of("bagley_torvik").problem, Grid{20.0, 8}), std::nullopt);
}

TEST(Resolution, TheTimesOfAnAdaptiveRunAreItsOwn) {
  std::vector<double> heard;
  const Options options{.observer = [&](double t, In /*y*/) { heard.push_back(t); }};
  const auto path = adaptive().solve(decay(1.0), Tolerance{1e-5, 1e-7}, options);
  EXPECT_EQ(path.status, SolveStatus::finished);
  EXPECT_EQ(path.times, heard);
  EXPECT_EQ(path.steps, path.y.cols() - 1);
  EXPECT_EQ(path.last_time, 2.0);
  EXPECT_EQ(path.cost.rhs_calls, path.steps);
  EXPECT_LT(path.time(1), path.time(path.steps) - path.time(path.steps - 2));
  EXPECT_NEAR(path.y(0, path.steps), std::exp(-2.0), 1e-2);
}

// The solution t^1.5 of a chain with links 1 and 0.5, with dense output.
TEST(Resolution, ADenseSolutionOfASplitProblemIsThatOfItsComponents) {
  const Solve whole_interval = [](const Problem& chain, const Resolution&, const Options&) {
    EXPECT_EQ(chain.size(), 2);
    return Trajectory{.times = {0.0},
                      .y = taylor_part(chain, 0.0),
                      .dense_output = [](double t) -> Vec {
                        return Vec{{std::pow(t, 1.5), 1.5 * std::sqrt(t)}};
                      },
                      .last_time = chain.end};
  };
  const auto path = with_split_orders(splitting_up_to_one, whole_interval)(decay(1.5), Grid{}, {});
  EXPECT_EQ(path.y.rows(), 1);
  EXPECT_EQ(path.dense_output(0.25), Vec::Constant(1, 0.125));
  EXPECT_FALSE(path.cost.rhs_calls.has_value());
}

TEST(Times, OfAGridAreFoundAgain) {
  for (const double grading : {1.0, 1.7, 4.0}) {
    const Grid grid{.end = 0.3, .steps = 1'000'003, .grading = grading};
    for (const int n : {0, 1, 2, 16, 999, 500'000, 1'000'002, 1'000'003})
      EXPECT_EQ(grid.nearest_index(grid.time(n)), n);
  }
}

TEST(Times, AskedForAreMetUpToRounding) {
  const auto path =
      solve("l1", decay(0.5), Grid{2.0, 20}, {.output_times = {0.0, 3 * 0.1, 0.35, 7 * 0.1, 2.0}});
  const Grid grid{2.0, 20};
  EXPECT_EQ(path.times, (std::vector{0.0, grid.time(3), grid.time(7), 2.0}));
  EXPECT_EQ(path.steps, 20);
}

}  // namespace
}  // namespace fde::bench
