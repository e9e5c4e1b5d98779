// SPDX-License-Identifier: MIT
// Recommendations from measured runs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/reports/analysis/recorded_recommendation.hpp"
#include "fdebench/reports/analysis/scene_lines.hpp"
#include "reports/synthetic_results.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

constexpr ErrorKind at_end{Norm::end, Scale::absolute};

std::vector<RecommendedRun> within(const Results& results, double accuracy) {
  return SceneLines(runs_of(results), {"pendulum"}).within(at_end, accuracy);
}

TEST(Options, AreTheQuickestRunsWithinTheAccuracy) {
  const auto ranked = within(two_lines(), 3e-5);
  ASSERT_EQ(ranked.size(), 2);
  EXPECT_EQ(ranked[0].schemes.front(), "l1");
  EXPECT_EQ(ranked[0].steps, 512);
  EXPECT_DOUBLE_EQ(ranked[0].time.median, 512e-6);
  const auto predicted = with_prediction(ranked[0], runs_of(two_lines()), {"pendulum"}, at_end);
  EXPECT_NEAR(predicted.predicted_error.value() / ranked[0].error, 1.0, 1e-3) << "by the coarser runs alone";
  EXPECT_EQ(ranked[1].schemes.front(), "adams_pc");
  EXPECT_EQ(ranked[1].steps, 256);
}

TEST(Options, LeaveOutSchemesThatDoNotReachTheError) {
  const auto ranked = within(two_lines(), 1e-5);
  ASSERT_EQ(ranked.size(), 1);
  EXPECT_EQ(ranked[0].schemes.front(), "adams_pc");
}

TEST(Options, PreferTheSmallerErrorAtEqualTimes) {
  Results results = empty_results();
  add_run(results, {"pendulum", "adams_pc", 64}, 2e-3, 1.0);
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  const auto ranked = within(results, 1e-2);
  ASSERT_EQ(ranked.size(), 2);
  EXPECT_EQ(ranked[0].schemes.front(), "l1");
}

// The record has the bound of the absolute error, 1e-5; the mixed error is half of the absolute error here.
TEST(Options, AreWithinTheAccuracyWithTheBoundOfTheReference) {
  Results results = empty_results();
  const SyntheticRun run{"pendulum", "l1", 64};
  add_run(results, run, 9e-5, 1.0);
  add_value(results, run, "error_end_mixed", 4.5e-5);
  add_value(results, run, "reference_bound", 1e-5);
  EXPECT_EQ(within(results, 1.01e-4).size(), 1);
  EXPECT_TRUE(within(results, 0.99e-4).empty());
  const Runs runs = runs_of(results);
  const SceneLines lines(runs, {"pendulum"});
  EXPECT_EQ(lines.within({Norm::end, Scale::mixed}, 5.01e-5).size(), 1);
  EXPECT_TRUE(lines.within({Norm::end, Scale::mixed}, 4.99e-5).empty());
  const auto missed = lines.shortfall(at_end, 0.99e-4, {});
  ASSERT_TRUE(missed);
  EXPECT_EQ(missed->known_up_to, 1e-5);
  EXPECT_FALSE(missed->is_no_better);
}

TEST(Options, CountARunMeasuredAgainWithItsLastSession) {
  Results results = empty_results();
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  results.sessions.push_back(results.sessions.front());
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 2.0);
  const auto ranked = within(results, 1e-2);
  ASSERT_EQ(ranked.size(), 1);
  EXPECT_EQ(ranked[0].time.median, 2.0);
  EXPECT_EQ(ranked[0].session, 1);
}

TEST(Options, AreNoRunsThatZeroWouldMatch) {
  Results results = empty_results();
  const SyntheticRun run{"pendulum", "l1", 64};
  add_value(results, run, "baseline_end", 5e-4);
  add_run(results, run, 1e-3, 1.0);
  EXPECT_TRUE(within(results, 1e-2).empty());
}

TEST(Options, DifferInTheKindOfError) {
  const auto ranked =
      SceneLines(runs_of(two_lines()), {"pendulum"}).within({Norm::maximum, Scale::absolute}, 0.1);
  ASSERT_EQ(ranked.size(), 2);
  EXPECT_EQ(ranked[0].error, end_time / ranked[0].steps);
}

TEST(Shortfall, NamesTheBestErrorAndTheStepsThatAreNeeded) {
  const Runs runs = runs_of(two_lines());
  const SceneLines lines(runs, {"pendulum"});
  const auto missed = lines.shortfall(at_end, 1e-9, lines.forecasts(at_end));
  ASSERT_TRUE(missed && missed->steps_needed);
  EXPECT_EQ(missed->best.schemes.front(), "adams_pc");
  EXPECT_EQ(missed->best.steps, 512);
  EXPECT_EQ(missed->line.schemes.front(), "adams_pc");
  const double exact = 512 * std::sqrt(0.01 / 4096 / 1e-9);
  EXPECT_NEAR(missed->steps_needed->value / exact, 1.0, 0.01);
  EXPECT_LE(missed->steps_needed->low, exact);
  EXPECT_GE(missed->steps_needed->high, exact);
  EXPECT_FALSE(SceneLines(runs, {"brusselator"}).shortfall(at_end, 1e-9, {}));
}

// A run that is examined but not timed is no option; it is counted as untimed.
TEST(Shortfall, CountsRunsThatAreNotTimedYet) {
  Results results = empty_results();
  const SyntheticRun run{"pendulum", "l1", 64};
  add_value(results, run, "error_end", 1e-5);
  EXPECT_TRUE(within(results, 1e-3).empty());
  EXPECT_EQ(SceneLines(runs_of(results), {"pendulum"}).shortfall(at_end, 1e-3, {})->untimed, 1U);
  EXPECT_THAT(recommend(runs_of(results), {"pendulum"}, at_end, 1e-3).missing,
              testing::Contains(HasSubstr("not timed yet")));
}

// The errors of adams_pc under another name, for fewer numbers of steps: one line, with the runs of the
// longer one.
TEST(Options, OfOneAlgorithmAreOneWithSeveralNames) {
  Results results = empty_results();
  for (const auto* scheme : {"adams_pc", "decoupled_multi_order"}) {
    for (const int steps : {8, 16, 32, 64, 128, 256}) {
      if (steps == 256 && std::string_view(scheme) == "decoupled_multi_order") continue;
      const SyntheticRun run{"pendulum", scheme, steps};
      add_value(results, run, "error_maximum", 1.0 / steps);
      add_run(results, run, 1.0 / steps, 1e-6 * steps);
    }
  }
  const auto ranked = within(results, 5e-3);
  ASSERT_EQ(ranked.size(), 1);
  EXPECT_EQ(ranked[0].steps, 256);
  EXPECT_THAT(ranked[0].schemes, ElementsAre("adams_pc", "decoupled_multi_order"));
  const Runs runs = runs_of(results);
  const SceneLines lines(runs, {"pendulum"});
  const auto missed = lines.shortfall(at_end, 1e-3, lines.forecasts(at_end));
  EXPECT_EQ(missed->line.schemes.front(), "adams_pc");
  EXPECT_GE(missed->steps_needed->low, 257.0);
}

RecommendedRun option(const std::string& scheme, int steps, const MedianInterval& time) {
  return {
      .schemes = {scheme}, .settings = {.resolution = steps}, .steps = steps, .error = 1e-7, .time = time};
}

// Time intervals [9, 11], [10.5, 13] and [20, 21].
TEST(Recommendation, TellsWhatIsWithinNoise) {
  const Recommendation made{
      .scene = {"pendulum"},
      .kind = at_end,
      .accuracy = 1e-6,
      .options = {option("l1", 512, {10.0, 9.0, 11.0}), option("adams_pc", 256, {12.0, 10.5, 13.0}),
                  option("product_trapezoidal", 64, {20.5, 20.0, 21.0})}};
  EXPECT_THAT(within_noise(made), ElementsAre("adams_pc"));
  EXPECT_EQ(runner_up(made)->schemes.front(), "adams_pc");
  const auto json = json_of(made);
  for (const auto* field :
       {"scene", "scheme", "grid", "asked", "steps", "norm", "scale", "error", "predicted_error", "seconds",
        "seconds_low", "seconds_high", "within_noise", "runner_up", "factor", "command"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  EXPECT_EQ(json["grid"], "uniform");
  EXPECT_TRUE(json["asked"].is_null()) << json["asked"];
  EXPECT_EQ(json["steps"], 512);
  EXPECT_DOUBLE_EQ(json["factor"], 1.2);
  EXPECT_EQ(json["command"], "fdebench solve pendulum --scheme l1 --steps 512");
  EXPECT_THAT(to_text(made), HasSubstr("within noise of adams_pc\n"));
  EXPECT_THAT(to_text(made, true), HasSubstr("2 times more steps"));
}

// Three lines answer: what to run, what it delivers, how sure that is; the table has a row a scheme.
TEST(Recommendation, AnswersInThreeLinesBeforeItsTable) {
  Recommendation made{
      .scene = {"pendulum"},
      .kind = at_end,
      .accuracy = 1e-6,
      .options = {option("bdf4", 512, {1e-3, 0.9e-3, 1.1e-3}), option("l1", 4096, {2e-3, 1.9e-3, 2.1e-3})},
      .rejected = {{.finest = option("bdf2", 64, {3e-3, 3e-3, 3e-3}), .reason = "slower"},
                   {.finest = {.schemes = {"power_series"}},
                    .reason = "refused: too many rows",
                    .refused = true}},
      .reference_bound = 1e-16};
  made.options.front().setup_seconds = 0.02;
  const std::string text = to_text(made);
  EXPECT_THAT(text,
              StartsWith("run: fdebench solve pendulum --scheme bdf4 --steps 512\n"
                         "delivers: error 1.0e-7 (at the end, absolute scale; 1.0e-6 wanted) in 1.00 ms; "
                         "21.0 ms for the first run of a process\n"
                         "how sure: the reference is known to 1.0e-16; the time is in 900 µs ... 1.10 ms "
                         "(95 %); l1 takes 2.00 times as long\n\nscheme"));
  EXPECT_THAT(text, HasSubstr("\nbdf2 "));
  EXPECT_THAT(text, Not(HasSubstr("power_series"))) << "what refuses the problem";
  EXPECT_THAT(to_text(made, true), HasSubstr("power_series"));
}

// A name may be that of a file from elsewhere, and the command is copied to a shell.
TEST(Recommendation, QuotesWhatAShellWouldTakeApart) {
  const auto run = option("l1", 64, {1e-3, 1e-3, 1e-3});
  EXPECT_EQ(command_of({"it's $(id).toml"}, run),
            "fdebench solve 'it'\\''s $(id).toml' --scheme l1 --steps 64");
  EXPECT_EQ(command_of({"pendulum:alpha=1.9"}, run),
            "fdebench solve pendulum:alpha=1.9 --scheme l1 --steps 64");
}

// bdf4 takes 2 ms and its first run 22 ms; adams_pc takes 5 ms at any time.
TEST(Recommendation, RanksByTheRunThatIsAskedFor) {
  Results results = empty_results();
  const SyntheticRun quick{"pendulum", "bdf4", 64};
  add_run(results, quick, 1e-4, 2e-3);
  add_value(results, quick, "time_setup", 0.02);
  add_run(results, {"pendulum", "adams_pc", 64}, 1e-4, 5e-3);
  const auto quickest = [&](bool first_run) {
    Runs runs = runs_of(results);
    if (first_run) count_first_runs(runs);
    return SceneLines(runs, {"pendulum"}).within(at_end, 1e-3).front();
  };
  EXPECT_EQ(quickest(false).schemes.front(), "bdf4");
  EXPECT_EQ(quickest(false).setup_seconds, 0.02);
  EXPECT_EQ(quickest(true).schemes.front(), "adams_pc");
}

TEST(Recommendation, SaysWhatToAskASchemeWithoutAGridFor) {
  RecommendedRun asked = option("spectral_collocation", 12, {1.0, 1.0, 1.0});
  asked.settings.resolution = Tolerance{.rtol = 1e-7, .atol = 1e-7};
  const auto json = json_of({.scene = {"pendulum"}, .kind = at_end, .accuracy = 1e-6, .options = {asked}});
  EXPECT_TRUE(json["grid"].is_null()) << json["grid"];
  EXPECT_EQ(json["asked"], 1e-7);
  EXPECT_EQ(json["command"], "fdebench solve pendulum --scheme spectral_collocation --accuracy 1e-07");
}

}  // namespace
}  // namespace fde::bench
