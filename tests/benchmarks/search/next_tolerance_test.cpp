// SPDX-License-Identifier: MIT
// The choice of the next tolerance, on configurations whose errors and times are given functions.

#include "fdebench/benchmarks/search/next_tolerance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "fdebench/benchmarks/search/next_resolution.hpp"

namespace fde::bench {
namespace {

constexpr double wanted = 1e-6;
const SearchGoal goal_of_one{.targets = {{0, wanted}}};

// A configuration with tolerances: error and seconds as functions of the tolerance.
Refinement searched_tolerances(const std::function<double(double)>& error,
                               const std::function<double(double)>& seconds) {
  Refinement of{.is_adaptive = true};
  while (const auto next = next_resolutions(goal_of_one, {&of, 1}).front()) {
    const double tolerance = std::get<Tolerance>(*next).rtol;
    of.add({.resolution = *next,
            .steps = 10,
            .seconds = seconds(tolerance),
            .errors = {{.value = error(tolerance), .baseline = 1.0}}});
    if (of.runs.size() > 100) break;
  }
  return of;
}

double chosen_tolerance(const Refinement& of) {
  const auto* best = quickest_within(of, {0, wanted});
  return best != nullptr ? std::get<Tolerance>(best->resolution).rtol : 0.0;
}

TEST(NextTolerances, FindALooseOneAlsoAboveTheAccuracy) {
  for (const double ratio : {1e-4, 0.02, 0.5, 1.0, 3.0, 70.0, 2e4}) {
    const auto of = searched_tolerances([=](double tolerance) { return ratio * tolerance; },
                                        [](double tolerance) { return 1e-5 * std::pow(tolerance, -0.1); });
    const double exact = wanted / ratio;
    EXPECT_LE(chosen_tolerance(of), exact) << ratio;
    EXPECT_GE(2.0 * chosen_tolerance(of), std::min(exact, 0.1)) << ratio;
  }
}

// A tighter tolerance takes fewer panels here, as on a solution that one polynomial fits.
TEST(NextTolerances, FindATighterOneThatIsQuicker) {
  const auto of = searched_tolerances([](double tolerance) { return 1e-5 * tolerance; },
                                      [](double tolerance) { return tolerance > 1e-3 ? 1.4e-5 : 7e-6; });
  EXPECT_EQ(*quickest_within(of, {0, wanted})->seconds, 7e-6);
}

TEST(NextTolerances, PrintAsTheyAreRead) {
  const auto of = searched_tolerances([](double tolerance) { return 3.0 * tolerance; },
                                      [](double tolerance) { return 1e-5 * std::pow(tolerance, -0.1); });
  EXPECT_TRUE(chosen_tolerance(of) == 1.8e-7 || chosen_tolerance(of) == 3.2e-7) << chosen_tolerance(of);
}

TEST(NextTolerances, AreNoneWhereErrorsDoNotFall) {
  const auto of = searched_tolerances([](double) { return 2.0 * wanted; }, [](double) { return 1e-5; });
  EXPECT_EQ(chosen_tolerance(of), 0.0);
  EXPECT_LE(of.runs.size(), 15U);
}

// Each tolerance takes ten times as long as the one before: no run is made that is expected to take more than
// most_seconds.
TEST(NextTolerances, AreNoLongerThanTheMostSeconds) {
  const auto of = searched_tolerances([](double tolerance) { return 100.0 * tolerance; },
                                      [](double tolerance) { return 1e-5 / tolerance; });
  for (const RefinementRun& run : of.runs) EXPECT_LE(*run.seconds, 0.1);
}

// The errors of 0.1 and 0.01 leave four decades, of which three are skipped at once; 3.2e-6 is expected to be
// three times outside.
TEST(NextTolerances, SkipWhatIsFarOutsideBeforeLongRuns) {
  const auto of = searched_tolerances([](double tolerance) { return tolerance; },
                                      [](double tolerance) { return 4e-3 * std::pow(tolerance, -0.2); });
  std::vector<double> tolerances;
  for (const RefinementRun& run : of.runs) tolerances.push_back(std::get<Tolerance>(run.resolution).rtol);
  EXPECT_THAT(tolerances, testing::ElementsAre(0.1, 0.01, 1e-5, 1e-6, 1.8e-6));
}

// A run that ended for want of time is made again where it may take clearly longer, unless another run is
// within the target, and it takes the place of the first.
TEST(NextTolerances, EndWhereTheTimeRunsOut) {
  const Tolerance tolerance{0.1, 0.1};
  Refinement of{.is_adaptive = true,
                .runs = {{.resolution = tolerance,
                          .seconds = 0.05,
                          .fails_with_more_steps = true,
                          .ending = {SolveStatus::out_of_budget, ""},
                          .errors = {{}}}}};
  const auto next = [&](double budget) {
    return next_resolutions({.targets = {{0, wanted}}, .budget_of_tolerance = budget}, {&of, 1}).front();
  };
  EXPECT_FALSE(next(0.0));
  EXPECT_FALSE(next(0.1));
  EXPECT_EQ(next(0.2), StepsOrTolerance(tolerance));
  of.add({.resolution = tolerance, .seconds = 0.1, .errors = {{.value = wanted, .baseline = 1.0}}});
  EXPECT_EQ(of.runs.size(), 1U);
  EXPECT_EQ(chosen_tolerance(of), 0.1);
}

}  // namespace
}  // namespace fde::bench
