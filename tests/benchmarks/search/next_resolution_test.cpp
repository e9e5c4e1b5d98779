// SPDX-License-Identifier: MIT
// The choice of the next run, on configurations whose errors and times are given functions.

#include "fdebench/benchmarks/search/next_resolution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace fde::bench {
namespace {

constexpr double accuracy = 1e-6;

// A configuration over grids: its error with a sign, and its seconds, as functions of the steps.
struct Model {
  std::function<double(double steps)> error;
  double seconds_a_step = 1e-7;
  int unit = 1;
};

SearchGoal goal_for(double wanted = accuracy) { return {.targets = {{0, wanted}}}; }

RefinementRun run_of(const Model& model, int steps) {
  const double error = model.error(steps);
  return {.resolution = steps,
          .steps = steps,
          .seconds = 1e-6 + model.seconds_a_step * steps,
          .fails_with_more_steps = std::isinf(error),
          .errors = {{.value = std::abs(error), .baseline = 1.0, .signed_value = error}}};
}

// Makes runs until none is left to make.
std::vector<Refinement> searched(const SearchGoal& goal, const std::vector<Model>& models) {
  std::vector<Refinement> refinements;
  for (const Model& model : models) refinements.push_back({.unit = model.unit});
  for (int turn = 0; turn < 1000; ++turn) {
    const auto next = next_resolutions(goal, refinements);
    if (std::ranges::none_of(next, [](const auto& run) { return run.has_value(); })) return refinements;
    for (std::size_t i = 0; i < models.size(); ++i)
      if (next[i]) refinements[i].add(run_of(models[i], std::get<int>(*next[i])));
  }
  ADD_FAILURE() << "the search does not end";
  return refinements;
}

int fewest_steps(const Refinement& of, double wanted = accuracy) {
  const auto* best = quickest_within(of, {0, wanted});
  return best != nullptr ? best->steps : 0;
}

std::vector<int> steps_of(const Refinement& of) {
  std::vector<int> steps;
  for (const RefinementRun& run : of.runs) steps.push_back(run.steps);
  return steps;
}

int finest(const Refinement& of) { return std::ranges::max(steps_of(of)); }

// Of the longest run, which is the finest one.
double most_seconds(const Refinement& of) {
  return *std::ranges::max_element(of.runs, {}, &RefinementRun::seconds)->seconds;
}

Model power(double constant, double rate, double seconds_a_step = 1e-7) {
  return {[=](double steps) { return constant * std::pow(steps, -rate); }, seconds_a_step};
}

TEST(NextResolutions, CloseOnTheFewestStepsOfAPowerInAFewRuns) {
  for (const double rate : {0.75, 1.0, 1.5, 2.0, 4.0}) {
    auto goal = goal_for();
    goal.most_seconds = 100.0;
    const auto found = searched(goal, {power(0.3, rate)}).front();
    const double exact = std::pow(0.3 / accuracy, 1.0 / rate);
    EXPECT_GE(fewest_steps(found), exact) << rate;
    EXPECT_LE(fewest_steps(found), 1.02 * exact + 1.0) << rate;
    const auto doubled = static_cast<std::size_t>(std::ceil(std::log2(exact / 4.0))) + 1;
    EXPECT_LE(found.runs.size(), doubled + 6) << rate;
  }
}

TEST(NextResolutions, GoBelowTheFirstRunWhereThatIsWithin) {
  const auto found = searched(goal_for(1e-2), {power(0.02, 1.0)}).front();  // 2 steps suffice
  EXPECT_EQ(fewest_steps(found, 1e-2), 2);
}

TEST(NextResolutions, AreMultiplesOfTheUnit) {
  auto model = power(1.0, 1.2);
  model.unit = 20;
  const auto found = searched(goal_for(), {model}).front();
  EXPECT_THAT(steps_of(found), testing::Each(testing::Truly([](int steps) { return steps % 20 == 0; })));
  EXPECT_LE(fewest_steps(found), 1.02 * 1e5 + 20.0);
}

// The error passes through 0 at 300 steps and exceeds the accuracy from there to nearly 1000 steps. Numbers
// of steps in a ratio of 1.05 miss the zero.
TEST(NextResolutions, FindWhereAnErrorChangesItsSign) {
  const Model model{[](double steps) { return 1e-3 * (1.0 - 300.0 / steps) * std::pow(100.0 / steps, 3.0); }};
  const auto found = searched(goal_for(), {model}).front();
  EXPECT_LE(fewest_steps(found), 308);
  EXPECT_GE(fewest_steps(found), 292);
}

// At one time the error is small by chance with 40 to 44 steps.
TEST(NextResolutions, ScanWhereAnErrorMayBeSmallByChance) {
  const Model model{[](double steps) { return steps >= 40 && steps <= 44 ? 1e-9 : 1e-2 / (steps * steps); }};
  auto goal = goal_for();
  goal.most_seconds_scanned = 1.0;
  EXPECT_GE(fewest_steps(searched(goal, {model}).front()), 100);
  goal.targets.front().may_pass_zero = true;
  EXPECT_LE(fewest_steps(searched(goal, {model}).front()), 44);
}

// Every configuration that is left has a run outside the accuracy that takes longer than the quickest within.
TEST(NextResolutions, LeaveASlowerConfigurationWithARunThatShowsIt) {
  const auto found = searched(goal_for(), {power(1.0, 1.0), power(1.0, 2.0), power(1.0, 4.0)});
  const double quickest = quickest_seconds(goal_for(), found).front();
  EXPECT_EQ(quickest, *quickest_within(found[2], {0, accuracy})->seconds);
  for (const std::size_t slower : {0U, 1U}) {
    EXPECT_EQ(fewest_steps(found[slower]), 0);
    EXPECT_GT(most_seconds(found[slower]), quickest);
    EXPECT_LT(most_seconds(found[slower]), 4.0 * quickest) << "and no more than needed";
  }
}

// Other processes may run beside any run, which then seems to take longer, whether it is outside or within.
TEST(NextResolutions, CloseOnTheFewestStepsBesideDisturbedRuns) {
  std::minstd_rand noise(1);
  std::uniform_real_distribution<double> disturbance(0.0, 3.0);
  for (int repetition = 0; repetition < 100; ++repetition) {
    const Model model = power(1e-3, 1.0);
    Refinement of;
    while (const auto next = next_resolutions(goal_for(), {&of, 1}).front()) {
      RefinementRun run = run_of(model, std::get<int>(*next));
      *run.seconds *= std::exp(disturbance(noise));
      of.add(run);
    }
    EXPECT_GE(fewest_steps(of), 1000);
    EXPECT_LE(fewest_steps(of), 1017);
  }
}

// The second configuration takes 100 times as long for a step: its next run waits until the first, which goes
// on with more and more steps, takes as long.
TEST(NextResolutions, AreDueBeforeThoseThatTakeFourTimesAsLong) {
  std::vector<Refinement> of_scene(3);
  const std::vector models{power(1.0, 1.0), power(1.0, 1.0, 1e-5), power(1.0, 1.0, 3e-7)};
  for (std::size_t i = 0; i < models.size(); ++i) of_scene[i].runs = {run_of(models[i], 1024)};
  const auto due = [&] { return due_runs(goal_for(), of_scene, next_resolutions(goal_for(), of_scene)); };
  EXPECT_THAT(due(), testing::ElementsAre(0, 2));
  of_scene[0].is_closed = of_scene[2].is_closed = true;
  EXPECT_THAT(due(), testing::ElementsAre(1));
  of_scene[1].is_closed = true;
  EXPECT_TRUE(due().empty());
}

// A step of either takes 1 us. Runs of the first one end at once until it is stable, with a million steps.
TEST(DueRuns, ExpectARunAfterOneThatFailedToTakeAllItsSteps) {
  Refinement unstable, stable;
  for (int steps = 64; steps <= 4096; steps *= 2) {
    unstable.add({.resolution = steps, .steps = steps, .seconds = 1e-6, .errors = {RunError{}}});
    stable.add(
        {.resolution = steps, .steps = steps, .seconds = 1e-6 * steps, .errors = {RunError{.value = 0.5}}});
  }
  const std::vector<Refinement> of_scene{unstable, stable};
  EXPECT_THAT(due_runs(goal_for(), of_scene, std::vector<std::optional<StepsOrTolerance>>{1 << 20, 8192}),
              testing::ElementsAre(1));
  EXPECT_THAT(due_runs(goal_for(), of_scene, std::vector<std::optional<StepsOrTolerance>>{8192, 8192}),
              testing::ElementsAre(0, 1));
}

// 0.1 s a run: the forecast says that rate 1 needs 1e6 steps and 1e3 times as long.
TEST(NextResolutions, LeaveALongConfigurationByItsForecast) {
  const auto found = searched(goal_for(), {power(1.0, 1.0, 1e-4), power(1.0, 2.0, 1e-4)});
  EXPECT_EQ(fewest_steps(found[0]), 0);
  EXPECT_LE(finest(found[0]), 1024);
  EXPECT_NEAR(fewest_steps(found[1]), 1000, 20);
}

// 0.01 s for 1000 steps are forecast, and no run has as many; 0.1 s of the other configuration is no longer
// too long.
TEST(NextResolutions, ReachWhatAConfigurationThatFailsWasForecastToReach) {
  constexpr double wanted = 1e-4;
  const Model failing{[](double steps) {
                        return steps < 512.0 ? 100.0 / (steps * steps)
                                             : std::numeric_limits<double>::infinity();
                      },
                      1e-5};
  const auto found = searched(goal_for(wanted), {failing, power(1.0, 1.0, 1e-5)});
  EXPECT_EQ(fewest_steps(found[0], wanted), 0);
  EXPECT_NEAR(fewest_steps(found[1], wanted), 10000, 200);
}

// The first configuration fails from 512 steps on; the other needs 1e7 steps of 10 us, and a run may take 0.3
// s.
TEST(NextResolutions, EndWhereTheForecastIsLongerThanTheMostSeconds) {
  const auto infinity = std::numeric_limits<double>::infinity();
  const Model failing{[=](double steps) { return steps < 512.0 ? 1.0 / (steps * steps) : infinity; }};
  const auto found = searched(goal_for(1e-7), {failing, power(1.0, 1.0, 1e-5)});
  EXPECT_EQ(fewest_steps(found[1], 1e-7), 0);
  EXPECT_LT(most_seconds(found[1]), 0.02);
}

TEST(NextResolutions, AreNoLongerThanTheMostSeconds) {
  auto goal = goal_for();
  goal.most_seconds = 1e-3;
  const auto found = searched(goal, {power(1.0, 1.0)}).front();
  EXPECT_EQ(finest(found), 8192);  // 0.82 ms
}

// Wall time with 0.5 s to start the process and 1.3 ms a step: only the steps count, up to 256 of them.
TEST(NextResolutions, DoNotCountTheStartOfAProcess) {
  auto goal = goal_for();
  goal.most_seconds = 0.3;
  Refinement of;
  for (const int steps : {64, 128, 256}) {
    of.runs.push_back(run_of(power(10.0, 1.0), steps));
    of.runs.back().is_whole_process = true;
    of.runs.back().seconds = 0.5 + 1.3e-3 * steps;
    const bool goes_on = next_resolutions(goal, {&of, 1}).front().has_value();
    EXPECT_EQ(goes_on, steps < 256) << steps;
  }
}

// A first run with 60 ms for start weights and 1 us a step: twice the steps take little longer.
TEST(Refinements, ForecastStartWeightsOnce) {
  Refinement of;
  for (const int steps : {64, 128, 256, 512}) {
    of.runs.push_back(run_of(power(1.0, 2.0), steps));
    of.runs.back().setup_seconds = 0.06;
    of.runs.back().first_run = true;
    of.runs.back().seconds = 0.06 + 1e-6 * steps;
  }
  EXPECT_NEAR(*seconds_with(of, 4096.0), 0.06 + 4096e-6, 1e-9);
  EXPECT_NEAR(forecast_seconds(of, {0, accuracy}, error_model(of, 0))->value, 0.061, 1e-4);
}

// The time grows with e^(-1/2); the last two errors are neighbours, and other work doubled the time of the
// last.
TEST(Refinements, ForecastByErrorsWithTolerancesThatAreFarApart) {
  Refinement of{.is_adaptive = true};
  const auto add = [&](double error, double seconds) {
    of.runs.push_back({.resolution = Tolerance{error, error}, .seconds = seconds, .errors = {{error}}});
  };
  const auto forecast = [&] { return forecast_seconds(of, {0, 1e-8}, error_model(of, 0)); };
  add(2e-4, 1e-3 / std::sqrt(2.0));
  add(1e-4, 1e-3);
  EXPECT_FALSE(forecast());
  add(1e-6, 1e-2);
  EXPECT_NEAR(forecast()->value, 0.1, 1e-3);
  add(0.9e-6, 2e-2);
  EXPECT_LT(forecast()->value, 0.6) << "by the neighbours it is 1.8 s";
}

TEST(NextResolutions, EndWhereMoreStepsEndInTheSameWay) {
  Refinement of{.runs = {{.resolution = 64, .steps = 64, .errors = {{}}}}};
  EXPECT_EQ(next_resolutions(goal_for(), {&of, 1}).front(), StepsOrTolerance(128)) << "more may succeed";
  of.runs.front().fails_with_more_steps = true;
  EXPECT_FALSE(next_resolutions(goal_for(), {&of, 1}).front());
}

// Steps up to where a run grew beyond all numbers took as long as those of a run that ends.
TEST(NextResolutions, LeaveASlowRunThatGrewBeyondAllNumbers) {
  std::vector<Refinement> of_scene{{.runs = {run_of(power(1.0, 2.0), 512), run_of(power(1.0, 2.0), 1024)}},
                                   {.runs = {{.resolution = 64, .steps = 64, .seconds = 2e-3}}}};
  EXPECT_EQ(next_resolutions(goal_for(), of_scene).back(), StepsOrTolerance(128))
      << "may end at once with more";
  of_scene[1].runs.front().ending.kind = SolveStatus::non_finite;
  EXPECT_FALSE(next_resolutions(goal_for(), of_scene).back());
}

// A run that failed has no errors at all, as in a forecast; beside a quick one it is left by its steps.
TEST(NextResolutions, DoubleTheStepsOfARunWithoutErrors) {
  std::vector<Refinement> of_scene{{.runs = {{.resolution = 64, .steps = 64, .seconds = 2e-3}}}, {}};
  of_scene[1].runs = {run_of(power(1.0, 2.0), 512), run_of(power(1.0, 2.0), 1024)};
  EXPECT_EQ(next_resolutions(goal_for(), of_scene).front(), StepsOrTolerance(128));
  of_scene[0].runs = {{.resolution = 1 << 20, .steps = 1 << 20, .seconds = 1e-5}};
  EXPECT_FALSE(next_resolutions(goal_for(), of_scene).front());
}

TEST(NextResolutions, EndWhereTheErrorIsRounding) {
  const Model model{[](double steps) { return 1e-9 + std::pow(steps, -4.0); }};
  const auto found = searched(goal_for(1e-12), {model}).front();
  EXPECT_LE(finest(found), 2048);
}

TEST(NextResolutions, EndWhereAConfigurationListedBeforeIsTheSameAlgorithm) {
  const auto found = searched(goal_for(1e-9), {power(1.0, 1.0), power(1.0, 1.0)});
  EXPECT_EQ(found[1].runs.size(), static_cast<std::size_t>(fewest_equal_runs));
  EXPECT_GT(found[0].runs.size(), found[1].runs.size());
}

TEST(SameAlgorithms, HaveFiveEqualErrors) {
  const auto of = [](int runs, double constant = 0.1) {
    Refinement made;
    for (int i = 0; i < runs; ++i) made.runs.push_back(run_of(power(constant, 2.0), 4 << i));
    return made;
  };
  EXPECT_TRUE(is_same_algorithm(of(5), of(7)));
  EXPECT_FALSE(is_same_algorithm(of(4), of(7))) << "four equal errors may be chance";
  auto nearly = of(5);
  nearly.runs.back().errors[0].value = std::nextafter(nearly.runs.back().errors[0].value, 0.0);
  EXPECT_FALSE(is_same_algorithm(of(5), nearly));
  EXPECT_FALSE(is_same_algorithm(of(5, 0.0), of(5, 0.0))) << "errors of 0 say nothing";
}

// Several targets: the cheapest run within each.
TEST(NextResolutions, ServeSeveralTargets) {
  SearchGoal goal = goal_for();
  goal.targets = {{0, 1e-2}, {0, 1e-4}, {0, 1e-6}};
  const auto found = searched(goal, {power(1.0, 2.0)}).front();
  for (const double wanted : {1e-2, 1e-4, 1e-6}) {
    const double exact = std::pow(wanted, -0.5);
    EXPECT_GE(fewest_steps(found, wanted), exact);
    EXPECT_LE(fewest_steps(found, wanted), 1.02 * exact + 1.0);
  }
}

}  // namespace
}  // namespace fde::bench
