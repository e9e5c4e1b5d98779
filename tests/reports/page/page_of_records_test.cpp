// SPDX-License-Identifier: MIT
// The page shows what the results say, also of scenes, schemes, quantities and endings that this build does
// not have.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/description_text.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "reports/synthetic_results.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

TEST(PageOfRecords, ShowsTheSceneAsTheResultsDescribeIt) {
  const auto scene = section(page_data(read_runs(two_lines())), "scene-pendulum");
  EXPECT_EQ(scene["title"], "Fractional pendulum");
  EXPECT_EQ(scene["equations"], (nlohmann::json{{{"left", "D(phi, 2)"}, {"right", "-sin(phi)"}}}));
  EXPECT_EQ(scene["solution"], json_of(*described_pendulum().solution));
  EXPECT_THAT(scene["parameters"].dump(), HasSubstr("an order"));
}

// Nothing is computed in its place.
TEST(PageOfRecords, LacksWhatTheResultsDoNotSay) {
  Results results = two_lines();
  results.scenes.clear();
  const auto data = page_data(read_runs(results));
  const auto scene = section(data, "scene-pendulum");
  EXPECT_EQ(scene["title"], "pendulum");
  for (const auto* part : {"equations", "parameters", "solution"}) EXPECT_FALSE(scene.contains(part)) << part;
  const auto row = section(data, "reference")["groups"][0]["rows"][0];
  for (const auto* fact : {"evidence", "seconds"}) EXPECT_FALSE(row.contains(fact)) << fact;
}

Results of_tomorrow() {
  Results results = two_lines();
  results.scenes.front().scene = {"tomorrow", {{"form", "new"}}};
  for (Record& run : results.records) {
    run.key.scene = results.scenes.front().scene;
    if (run.key.scheme == "l1") run.key.scheme = "better_l1";
    run.values.set("beauty", *run["expected_rate_end"]);
    run.values.erase("expected_rate_end");
  }
  add_ending(results, {"tomorrow", "better_l1", 32}, 1.0, {outcome_named("went_home"), "early"});
  return results;
}

TEST(PageOfRecords, ShowsWhatThisBuildDoesNotHave) {
  const auto data = page_data(read_runs(of_tomorrow()));
  EXPECT_THAT(data["lines"].get<std::vector<std::string>>(),
              testing::UnorderedElementsAre("adams_pc", "better_l1"));
  const auto scene = section(data, "scene-tomorrow:form=new");
  EXPECT_EQ(scene["title"], "Fractional pendulum (form=new)");
  EXPECT_EQ(scene["solution"], json_of(*described_pendulum().solution));
  EXPECT_EQ(scene["runs"]["steps"].size(), 8U);
  EXPECT_THAT(section(data, "failures").dump(), AllOf(HasSubstr("went_home"), HasSubstr("early")));
  EXPECT_THAT(section(data, "schemes").dump(), HasSubstr("better_l1"));
}

}  // namespace
}  // namespace fde::bench
