// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/own_scheme.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "support/testing.hpp"

namespace fde::bench {
namespace {

Rows squares(const Problem& problem, const std::vector<double>& times) {
  Rows y(problem.size(), std::ssize(times));
  for (Eigen::Index c = 0; const double t : times) y.col(c++).setConstant(t * t);
  return y;
}

TEST(OwnScheme, ReturnsTheRequestedTimesAndTellsTheObserverAll) {
  const OwnScheme mine("squares", squares);
  const Problem& problem = scene_of("relaxation").problem;
  std::vector<double> seen;
  const Options options{.output_times = {0.5, 1.0}, .observer = [&](double t, In) { seen.push_back(t); }};
  const auto path = mine.scheme().solve(problem, Grid{.end = 1.0, .steps = 4}, options);
  EXPECT_EQ(path.status, SolveStatus::finished);
  EXPECT_THAT(path.times, testing::ElementsAre(0.5, 1.0));
  EXPECT_EQ(path.y(0, 0), 0.25);
  EXPECT_THAT(seen, testing::ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
  EXPECT_EQ(path.steps, 4);
  EXPECT_EQ(mine.scheme().solve(problem, Grid{.end = 1.0, .steps = 4}, {}).times.size(), 5U);
}

TEST(OwnScheme, EndsWhereAStateIsNotFinite) {
  const OwnScheme mine("poles", [](const Problem& problem, const std::vector<double>& times) {
    Rows y = squares(problem, times);
    y(0, 3) = std::nan("");
    return y;
  });
  const auto path = mine.scheme().solve(scene_of("relaxation").problem, Grid{.end = 1.0, .steps = 4}, {});
  EXPECT_EQ(path.status, SolveStatus::non_finite);
  EXPECT_EQ(path.last_time, 0.5);
  EXPECT_EQ(path.failure_time, 0.75);
  EXPECT_EQ(path.y.cols(), 3);
}

// 0.3 is no time n / 10 of the grid to the last bit: times are equal up to rounding.
TEST(OwnScheme, ReturnsTimesThatAreRequestedUpToRounding) {
  const OwnScheme mine("squares", squares);
  const auto path = mine.scheme().solve(scene_of("relaxation").problem, Grid{.end = 1.0, .steps = 10},
                                        {.output_times = {0.3, 0.7, 1.0}});
  EXPECT_EQ(path.times.size(), 3U);
  EXPECT_NEAR(path.y(0, 1), 0.49, 1e-15);
}

TEST(OwnScheme, EndsWhereItsBudgetIsSpent) {
  const OwnScheme mine("slow", [](const Problem& problem, const std::vector<double>& times) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return squares(problem, times);
  });
  const auto path =
      mine.scheme().solve(scene_of("relaxation").problem, Grid{.end = 1.0, .steps = 4}, {.budget = 0.01});
  EXPECT_EQ(path.status, SolveStatus::out_of_budget);
}

TEST(OwnScheme, RefusesStatesOfAnotherShape) {
  const OwnScheme mine("short", [](const Problem&, const std::vector<double>&) { return Rows(1, 2); });
  EXPECT_THROW(mine.scheme().solve(scene_of("relaxation").problem, Grid{.end = 1.0, .steps = 4}, {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
