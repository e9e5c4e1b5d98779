// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fdebench/benchmarks/sweep/trials.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"

namespace fde::bench {
namespace {

using testing::ElementsAre;

// Adds a run of a scene: its ending and, if it finished, its error and time.
void add_run(Results& results, const SceneSettings& scene, const std::string& scheme, int steps,
             const RunOutcome& ending, double error) {
  const Record row{.key = {.scene = scene, .scheme = scheme, .setup = {.resolution = steps}},
                   .steps = steps,
                   .h = 1.0 / steps};
  const auto add = [&](const std::string& quantity, double value) -> Record& {
    results.records.push_back(row);
    results.records.back().quantity = quantity;
    results.records.back().value = value;
    return results.records.back();
  };
  const bool finished = ending == RunOutcome{};
  if (finished) {
    add("error_end", error);
    add("error_relative", error);
  }
  add("ending", 1.0).ending = ending;
  if (finished) add("time_minimum", 1e-3);
}

std::vector<std::string> texts(const nlohmann::json& row) {
  std::vector<std::string> all;
  for (const auto& cell : row) all.push_back(to_text(cell));
  return all;
}

TEST(StabilitySection, HasAVerdictInEveryCell) {
  const Trial& first = trials().front();
  Results results{.sessions = {Session{}}, .records = {}};
  add_run(results, first.scene.key(), "adams_pc", first.steps,
          {SolveStatus::non_finite, "at step 7, t = 0.5"}, 0.0);
  add_run(results, first.scene.key(), "l1", first.steps, {}, 1e-4);
  add_run(results, trials()[1].scene.key(), "l1", trials()[1].steps, {}, 0.5);
  const auto table = section(page_data(read_runs(results)), "stability")["table"];
  const auto& groups = table["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_THAT(texts(groups[0]["rows"][0]), ElementsAre("survived", "0 of 1", "1 of 2"));
  EXPECT_EQ(groups[1]["title"], first.kind);
  EXPECT_THAT(texts(groups[1]["rows"][0]), ElementsAre(first.scene.label(), "fails", "survives"));
  EXPECT_THAT(texts(groups[1]["rows"][1]), ElementsAre(trials()[1].scene.label(), "not run", "inaccurate"));
  EXPECT_EQ(groups[1]["rows"][0][1]["hint"], "not finite at step 7, t = 0.5");
}

TEST(StabilitySection, LeavesScenesWithTrialsOnlyToItself) {
  const Trial& first = trials().front();
  Results results{.sessions = {Session{}}, .records = {}};
  add_run(results, first.scene.key(), "l1", first.steps, {}, 1e-4);
  EXPECT_TRUE(section(page_data(read_runs(results)), "answer").is_null());
  add_run(results, first.scene.key(), "l1", first.steps / 2, {}, 1e-4);
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
