// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/solve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "support/refusal_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

SolveRequest steps_of(std::string scheme, int steps) {
  SolveRequest request{.scheme = std::move(scheme)};
  request.settings.resolution = steps;
  return request;
}

SolveRequest accuracy_of(std::string scheme, double accuracy) {
  SolveRequest request{.scheme = std::move(scheme)};
  request.settings.resolution = Tolerance{.rtol = accuracy, .atol = accuracy};
  return request;
}

// E_{1/2}(-t^{1/2}) = e^t erfc(t^{1/2}) at t = 1.
TEST(RequestedSolve, EndsAtTheSolutionWithEachKindOfOutputTimes) {
  const Scene scene = scene_of("relaxation");
  const double known = std::exp(1.0) * std::erfc(1.0);
  const std::vector<std::pair<OutputTimes, Eigen::Index>> kinds{
      {AllTimes{}, 65}, {GivenTimes{{1.0, 0.5}}, 2}, {EveryTime{10}, 8}, {SpreadTimes{5}, 5}};
  for (const auto& [times, count] : kinds) {
    auto request = steps_of("bdf4", 64);
    request.times = times;
    const auto table = solve(scene, request);
    ASSERT_EQ(table.values.cols(), count);
    EXPECT_EQ(table.times.back(), 1.0);
    EXPECT_NEAR(table.values(0, count - 1), known, 1e-5);
    EXPECT_TRUE(table.warnings.empty()) << warning_text(table.warnings);
  }
}

TEST(RequestedSolve, KeepsTheUnknownsAndCountsTheCallsWhereThatIsAsked) {
  auto request = steps_of("l1", 16);
  request.field = true;
  const Scene scene = scene_of("pendulum");
  const auto table = solve(scene, request);
  EXPECT_EQ(table.field.rows(), scene.problem.size());
  EXPECT_EQ(table.field.cols(), 17);
  const auto cost = json_of(table.cost);
  EXPECT_EQ(cost.begin().key(), "seconds");
  EXPECT_EQ(cost["rhs"], *table.cost.of_scheme.rhs_calls);
  EXPECT_FALSE(cost.contains("checkpoints"));
}

// A step of the explicit scheme is far outside its region of stability.
TEST(RequestedSolve, SaysWhatSpeaksAgainstTheValues) {
  const auto table = solve(scene_of("relaxation", {{"lambda", -200.0}}), steps_of("adams_pc", 64));
  ASSERT_FALSE(table.warnings.empty());
  EXPECT_EQ(table.warnings.front().finding, Finding::stability);
  EXPECT_THAT(warning_text(table.warnings), testing::StartsWith(table.warnings.front().text));
}

TEST(RequestedSolve, NamesTheFieldsThatItRefuses) {
  const Scene scene = scene_of("relaxation");
  const auto of = [&](SolveRequest request, auto change) {
    change(request);
    return refusal_of([&] { solve(scene, request); });
  };
  const auto grid = steps_of("l1", 8), adaptive = accuracy_of("adaptive_pc", 1e-4);
  EXPECT_EQ(of(steps_of("l1", 0), [](auto&) {}), "<steps> = 0: must be a whole number from 1 to 1000000000");
  EXPECT_EQ(of({.scheme = "l1"}, [](auto&) {}), of(steps_of("l1", 0), [](auto&) {}));
  EXPECT_EQ(of(accuracy_of("adaptive_pc", -1.0), [](auto&) {}),
            "<accuracy> = -1: must be a finite number above 0");
  EXPECT_EQ(of(grid, [](auto& r) { r.settings.grading = 0.5; }),
            "<grid> = 0.5: must be a number in [1, 100]");
  EXPECT_EQ(of(grid, [](auto& r) { r.threads = 0; }), "<threads> = 0: must be a whole number from 1 to 1024");
  EXPECT_THAT(of(grid, [](auto& r) { r.settings.budget = std::nan(""); }),
              testing::StartsWith("<budget> = nan: must be "));
  EXPECT_THAT(of(grid, [](auto& r) { r.settings.newton_tolerance = 2.0; }),
              testing::StartsWith("<tolerance> = 2: must be "));
  EXPECT_EQ(of(grid, [](auto& r) { r.times = GivenTimes{{0.3}}; }),
            "<at> = 0.3: must be a time of the grid: its neighbours are 0.25 and 0.375");
  EXPECT_EQ(of(grid, [](auto& r) { r.times = GivenTimes{}; }), "<at> = []: must be one time at least");
  EXPECT_EQ(of(grid, [](auto& r) { r.times = GivenTimes{{2.0}}; }),
            "<at> = 2: must be in [0, 1], the times of the run");
  EXPECT_EQ(of(adaptive, [](auto& r) { r.times = EveryTime{2}; }),
            "<every> = 2: must be with <steps>; with <accuracy> <points> K prints K equal times");
  EXPECT_EQ(of(adaptive, [](auto& r) { r.settings.grading = 2.0; }),
            "<grid> = graded:2: must be without <accuracy>, whose schemes choose their times");
  EXPECT_EQ(of(grid, [](auto& r) { r.events = true; }), "<events>: is only taken with <accuracy>");
  EXPECT_EQ(of(grid, [](auto& r) { r.all_solutions = true; }),
            "<all>: is only taken of problems at both ends");
  EXPECT_EQ(of(steps_of("bdf2", 8),
               [](auto& r) {
                 r.field = true;
                 r.checkpoint = CheckpointRequest{"file"};
               }),
            "<field>: is not taken with <checkpoint>");
  EXPECT_THAT(of(steps_of("adaptive_pc", 8), [](auto&) {}), testing::StartsWith("<scheme> = adaptive_pc: "));
}

TEST(SolveRequest, TakesOneOfTheFieldsThatExcludeEachOther) {
  EXPECT_EQ(std::get<int>(resolution_from(8, std::nullopt)), 8);
  EXPECT_EQ(std::get<Tolerance>(resolution_from(std::nullopt, 1e-3)).atol, 1e-3);
  EXPECT_EQ(refusal_of([] { resolution_from(std::nullopt, std::nullopt); }), "<steps> is required");
  EXPECT_EQ(std::get<EveryTime>(output_times_from(std::nullopt, 3, std::nullopt)).stride, 3);
  EXPECT_EQ(refusal_of([] { output_times_from(std::nullopt, 3, 5); }),
            "<at>, <every> and <points>: one of them at most");
  SolveRequest request;
  set_grid(request, "graded:3");
  EXPECT_EQ(request.settings.grading, 3.0);
  set_grid(request, "graded:auto");
  EXPECT_TRUE(request.optimal_grading);
  EXPECT_EQ(refusal_of([&] { set_grid(request, "square"); }),
            "<grid> = square: must be uniform or graded:R with R in [1, 100], or graded:auto");
}

}  // namespace
}  // namespace fde::bench
