// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

// Adds a run of a scene: its ending and, if it finished, its error and time.
void add_run(Results& results, const SceneSettings& scene, const std::string& scheme, int steps,
             const RunOutcome& ending, double error) {
  Record run{.key = {.scene = scene, .scheme = scheme, .settings = {.resolution = steps}},
             .steps = steps,
             .end = 1.0,
             .ending = ending};
  if (ending == RunOutcome{}) {
    run.values.set("error_end", error);
    run.values.set("error_relative", error);
    run.timing.values.set("time_minimum", 1e-3);
  }
  results.records.push_back(std::move(run));
}

constexpr int steps_of_trials = 4096;

SceneSettings stiff(int number) { return {"stiff_relaxation", {{"lambda", -10.0 * number}}}; }

// Results that describe two trials, in the wrong order.
Results with_trials() {
  Results results{.sessions = {Session{}}, .records = {}};
  for (const int number : {2, 1}) {
    results.scenes.push_back(
        {.scene = stiff(number), .trial = TrialRuns{number, "Stiff", steps_of_trials, {1e-6, 1e-300}}});
  }
  return results;
}

// The verdicts of a row; empty where a scheme was not run.
std::vector<std::string> verdicts(const nlohmann::json& row) {
  std::vector<std::string> all;
  for (const auto& cell : row["cells"]) all.push_back(cell.is_null() ? "" : cell["verdict"]);
  return all;
}

TEST(StabilitySection, HasAVerdictInEveryCell) {
  Results results = with_trials();
  add_run(results, stiff(1), "adams_pc", steps_of_trials, {SolveStatus::non_finite, "at step 7, t = 0.5"},
          0.0);
  add_run(results, stiff(1), "l1", steps_of_trials, {}, 1e-4);
  add_run(results, stiff(2), "l1", steps_of_trials, {}, 0.5);
  const auto of = section(page_data(read_runs(results)), "stability");
  EXPECT_THAT(of["lines"], ElementsAre("adams_pc", "l1"));
  const auto& groups = of["groups"];
  ASSERT_EQ(groups.size(), 2U);
  const auto& totals = groups[0]["rows"][0]["cells"];
  EXPECT_EQ(totals[0], nlohmann::json({{"survive", 0}, {"trials", 1}}));
  EXPECT_EQ(totals[1], nlohmann::json({{"survive", 1}, {"trials", 2}}));
  EXPECT_EQ(groups[1]["title"], "Stiff");
  const auto& rows = groups[1]["rows"];
  EXPECT_EQ(rows[0]["scene"], label_of(stiff(1)));
  EXPECT_EQ(rows[1]["scene"], label_of(stiff(2)));
  EXPECT_THAT(verdicts(rows[0]), ElementsAre("fails", "survives"));
  EXPECT_THAT(verdicts(rows[1]), ElementsAre("", "inaccurate"));
  EXPECT_EQ(rows[0]["cells"][0]["ending"], "not_finite");
  EXPECT_EQ(rows[0]["cells"][0]["detail"], "at step 7, t = 0.5");
}

TEST(StabilitySection, LeavesScenesWithTrialsOnlyToItself) {
  Results results = with_trials();
  add_run(results, stiff(1), "l1", steps_of_trials, {}, 1e-4);
  EXPECT_TRUE(section(page_data(read_runs(results)), "answer").is_null());
  add_run(results, stiff(1), "l1", steps_of_trials / 2, {}, 1e-4);
  EXPECT_FALSE(section(page_data(read_runs(results)), "answer").is_null());
  EXPECT_FALSE(section(page_data(read_runs(results)), "stability").is_null());
}

TEST(StabilitySection, IsLeftOutWithoutTrials) {
  Results results{.sessions = {Session{}}, .records = {}};
  add_run(results, {"relaxation"}, "l1", 64, {}, 1e-4);
  EXPECT_TRUE(section(page_data(read_runs(results)), "stability").is_null());
}

}  // namespace
}  // namespace fde::bench
