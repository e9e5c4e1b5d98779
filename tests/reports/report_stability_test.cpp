#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "page/page_data.hpp"
#include "sweep/trials.hpp"

namespace fde {
namespace {

using testing::ElementsAre;

// A run of a scene's label: its outcome and, where it came to its end, its error and time.
void add_run(Results& results, const std::string& scene, const std::string& scheme, int steps,
             const std::string& status, double error) {
  Record row{.scene = scene, .scheme = scheme, .history = "auto", .steps = steps, .h = 1.0 / steps};
  const auto add = [&](const std::string& quantity, double value, const std::string& text = {}) {
    row.quantity = quantity;
    row.value = value;
    row.status = text;
    results.records.push_back(row);
  };
  if (status == "finished") {
    add("error_end", error);
    add("error_relative", error);
  }
  add("outcome", 1.0, status);
  if (status == "finished") add("time_minimum", 1e-3, "timed");
}

nlohmann::json section(const nlohmann::json& page, const std::string& id) {
  for (const auto& one : page["sections"]) {
    if (one["id"] == id) return one;
  }
  return {};
}

std::vector<std::string> texts(const nlohmann::json& row) {
  std::vector<std::string> all;
  for (const auto& cell : row) all.push_back(cell["text"]);
  return all;
}

TEST(StabilitySection, HasAVerdictInEveryCell) {
  const Trial& first = trials().front();
  Results results{.sessions = {Session{}}, .records = {}};
  add_run(results, first.scene.label(), "adams_pc", first.steps, "not finite at step 7, t = 0.5", 0.0);
  add_run(results, first.scene.label(), "l1", first.steps, "finished", 1e-4);
  add_run(results, trials()[1].scene.label(), "l1", trials()[1].steps, "finished", 0.5);
  const auto table = section(page_data(results), "stability")["table"];
  const auto& groups = table["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_THAT(texts(groups[0]["rows"][0]), ElementsAre("survived", "0 of 1", "1 of 2"));
  EXPECT_EQ(groups[1]["title"], first.kind);
  EXPECT_THAT(texts(groups[1]["rows"][0]), ElementsAre(first.scene.label(), "fails", "survives"));
  EXPECT_THAT(texts(groups[1]["rows"][1]), ElementsAre(trials()[1].scene.label(), "not run", "inaccurate"));
  EXPECT_EQ(groups[1]["rows"][0][1]["detail"], "not finite at step 7, t = 0.5");
}

TEST(StabilitySection, LeavesScenesWithTrialsOnlyToItself) {
  const Trial& first = trials().front();
  Results results{.sessions = {Session{}}, .records = {}};
  add_run(results, first.scene.label(), "l1", first.steps, "finished", 1e-4);
  EXPECT_TRUE(section(page_data(results), "answer").is_null());
  add_run(results, first.scene.label(), "l1", first.steps / 2, "finished", 1e-4);
  EXPECT_FALSE(section(page_data(results), "answer").is_null());
  EXPECT_FALSE(section(page_data(results), "stability").is_null());
}

TEST(StabilitySection, IsLeftOutWithoutTrials) {
  Results results{.sessions = {Session{}}, .records = {}};
  add_run(results, "relaxation", "l1", 64, "finished", 1e-4);
  EXPECT_TRUE(section(page_data(results), "stability").is_null());
}

}  // namespace
}  // namespace fde
