// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/quicker_scheme.hpp"

#include <gtest/gtest.h>

#include <future>
#include <optional>

#include "fdebench/benchmarks/requests/solve.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using namespace std::chrono_literals;

RequestedRun run_of(const Scene& scene, const StepsOrTolerance& resolution, const std::string& scheme) {
  SolveRequest request{.scheme = scheme};
  request.settings.resolution = resolution;
  return requested_run(scene, request);
}

// What the search beside a run finds that lasts until then, or for `most`.
std::optional<QuickerScheme> found_beside(const Scene& scene, const RequestedRun& run,
                                          std::chrono::milliseconds first, std::chrono::milliseconds most) {
  std::promise<QuickerScheme> found;
  auto result = found.get_future();
  const auto search =
      quicker_scheme_search(scene, run, first, [&](const QuickerScheme& made) { found.set_value(made); });
  if (result.wait_for(most) != std::future_status::ready) return std::nullopt;
  return result.get();
}

TEST(QuickerScheme, TakesLessThanAHundredthOfTheRun) {
  const Scene scene = scene_of("relaxation");
  const auto found = found_beside(scene, run_of(scene, 1 << 20, "l1"), 200ms, 1min);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scheme, "spectral_collocation");
  EXPECT_EQ(found->accuracy, 1e-8);
  EXPECT_LT(100.0 * found->seconds, found->seconds_of_run);
}

TEST(QuickerScheme, IsAnotherOneToTheSameAccuracy) {
  const Scene scene = scene_of("relaxation");
  const auto run = run_of(scene, Tolerance{1e-3, 1e-3}, "spectral_collocation");
  const auto found = found_beside(scene, run, 200ms, 1min);
  ASSERT_TRUE(found);
  EXPECT_NE(found->scheme, "spectral_collocation");
  EXPECT_EQ(found->accuracy, 1e-3);
}

// No scheme solves it in a hundredth of a microsecond; ten thousand unknowns are not tried.
TEST(QuickerScheme, IsNotSaidOfQuickOrLargeRuns) {
  const Scene scene = scene_of("relaxation"),
              large = scene_of("fractional_diffusion", {{"components", 10000.0}});
  EXPECT_FALSE(found_beside(scene, run_of(scene, 64, "l1"), 1min, 10ms));
  EXPECT_FALSE(found_beside(large, run_of(large, 64, "l1"), 0ms, 100ms));
}

// The run lasts until the search has found one.
TEST(QuickerScheme, IsReportedOnceByASolve) {
  int reports = 0;
  SolveRequest request{.scheme = "grunwald_letnikov"};
  request.settings.resolution = 1 << 17;
  request.settings.history = HistoryKind::direct;
  solve(
      scene_of("relaxation"), request,
      {.quicker = [&](const QuickerScheme&) { ++reports; }, .long_run = std::chrono::duration<double>(0.05)});
  EXPECT_EQ(reports, 1);
}

}  // namespace
}  // namespace fde::bench
