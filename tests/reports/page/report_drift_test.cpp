// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/reports/analysis/formulations.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

using testing::Each;

MATCHER(IsNull, "") { return arg.is_null(); }

constexpr double drift_end = 8.0;

// A line of four numbers of steps whose drifts are proportional to h^rate and whose times are proportional to
// N.
struct Line {
  SceneSettings scene;
  double internal, independent, rate, seconds_a_step;
  RunOutcome ending{};
  int finest = 512;
};

// The largest drift up to t, as it is recorded.
Course course_to(double drift) { return {{0.5 * drift_end, drift_end}, {0.5 * drift, drift}}; }

void add_line(Results& results, const Line& line) {
  for (int steps = 64; steps <= line.finest; steps *= 2) {
    const double h = drift_end / steps, fallen = std::pow(h, line.rate);
    Record run{.key = {.scene = line.scene, .scheme = "l1", .settings = {.resolution = steps}},
               .steps = steps,
               .end = drift_end,
               .ending = line.ending};
    run.values.set("drift_internal", line.internal * fallen);
    if (line.independent > 0.0) {
      run.values.set("drift_independent", line.independent * fallen);
      run.values.set("drift_independent_growth", 1.25);
      run.courses["drift_independent"] = course_to(line.independent * fallen);
    }
    if (line.ending == RunOutcome{}) {
      run.values.set("error_end", 0.01 * h);
      run.timing.values.set("time_minimum", line.seconds_a_step * steps);
    }
    results.records.push_back(std::move(run));
  }
}

// The scene with these settings.
SceneSettings with(ParameterValues values) {
  return {.id = "fractional_constraint_2d", .values = std::move(values)};
}

// Their description by title and default formulation.
SceneDescription described(const SceneSettings& scene) {
  return {.scene = scene,
          .title = "A constraint",
          .parameters = {{"formulation", "integrated", "how it is posed"}}};
}

Results results_without_runs() {
  return {.sessions = {Session{}},
          .records = {},
          .scenes = {described(with({})), described(with({{"alpha", 0.3}}))}};
}

Results three_formulations() {
  Results results = results_without_runs();
  add_line(results, {with({{"alpha", 0.3}}), 1e-16, 1e-3, 1.5, 1e-6});
  add_line(results, {with({{"alpha", 0.3}, {"formulation", "acceleration"}}), 1e-2, 2e-2, 1.0, 1e-6});
  add_line(results, {with({{"alpha", 0.3}, {"formulation", "multiplier"}}), 1e-16, 1e-3, 1.5, 4e-6});
  return results;
}

nlohmann::json section_of(const Results& results) {
  const auto data = page_data(read_runs(results));
  for (const auto& section : data["sections"]) {
    if (section["id"] == "drift") return section;
  }
  return {};
}

// A fact of every row of the first scene, null where a row lacks it.
std::vector<nlohmann::json> facts(const nlohmann::json& section, const std::string& pointer) {
  std::vector<nlohmann::json> all;
  const nlohmann::json::json_pointer path(pointer);
  for (const auto& row : section["groups"][0]["rows"])
    all.push_back(row.contains(path) ? row[path] : nlohmann::json());
  return all;
}

MATCHER_P(IsAbout, value, "") {
  return arg.is_number() && std::abs(arg.template get<double>() / value - 1.0) < 0.03;
}

TEST(DriftSection, SetsTheFormulationsOfASceneSideBySide) {
  const auto section = section_of(three_formulations());
  EXPECT_EQ(section["groups"].size(), 1U);
  EXPECT_THAT(section["groups"][0]["title"], HasSubstr("(alpha=0.3)"));
  EXPECT_THAT(facts(section, "/formulation"), ElementsAre("integrated", "acceleration", "multiplier"));
  EXPECT_THAT(facts(section, "/independent/largest"),
              ElementsAre(IsAbout(2.0e-6), IsAbout(3.1e-4), IsAbout(2.0e-6)));
  EXPECT_THAT(facts(section, "/independent/growth"), Each(IsAbout(1.25)));
  EXPECT_THAT(facts(section, "/independent/rate"), ElementsAre(IsAbout(1.5), IsAbout(1.0), IsAbout(1.5)));
  EXPECT_THAT(facts(section, "/internal/rate"), ElementsAre(IsNull(), IsAbout(1.0), IsNull()));
  EXPECT_THAT(facts(section, "/time_minimum"),
              ElementsAre(IsAbout(512e-6), IsAbout(512e-6), IsAbout(2048e-6)));
}

// The multiplier formulation makes 128 steps in 512 µs.
TEST(DriftSection, FindsWhichFormulationIsBestInTheSameTime) {
  const auto section = section_of(three_formulations());
  ASSERT_EQ(section["best_in_time"].size(), 1U);
  const auto& found = section["best_in_time"][0];
  EXPECT_THAT(found["seconds"], IsAbout(512e-6));
  EXPECT_EQ(found["best"]["formulation"], "integrated");
  EXPECT_EQ(found["best"]["line"], "l1");
  EXPECT_EQ(found["best"]["steps"], 512);
  EXPECT_THAT(found["best"]["drift"], IsAbout(2.0e-6));
  EXPECT_THAT(found["best"]["error_end"], IsAbout(1.56e-4));
  ASSERT_EQ(found["others"].size(), 2U);
  EXPECT_EQ(found["others"][0]["formulation"], "multiplier");
  EXPECT_EQ(found["others"][0]["steps"], 128);
  EXPECT_EQ(found["others"][1]["formulation"], "acceleration");
  EXPECT_THAT(section["at_rounding"], ElementsAre("integrated", "multiplier"));
}

TEST(DriftSection, FollowsTheNumbers) {
  Results results = results_without_runs();
  add_line(results, {with({}), 1e-2, 1e-2, 1.0, 1e-6});
  add_line(results, {with({{"formulation", "multiplier"}}), 1e-3, 1e-3, 1.0, 1e-6});
  const auto section = section_of(results);
  EXPECT_EQ(section["best_in_time"][0]["best"]["formulation"], "multiplier");
  EXPECT_FALSE(section.contains("at_rounding"));
}

TEST(DriftSection, ComparesAtTheFinestCommonStepCount) {
  Results results = three_formulations();
  add_line(results, {with({{"alpha", 0.3}, {"formulation", "stabilised"}}), 1e-3, 1e-3, 1.0, 1e-6, {}, 256});
  EXPECT_THAT(facts(section_of(results), "/steps"), ElementsAre(256, 256, 256, 256));
}

TEST(DriftSection, TakesRunsWithoutAReference) {
  Results results = results_without_runs();
  add_line(results, {with({}), 1e-2, 0.0, 1.0, 1e-6, {Verdict::no_reference, "none is known"}});
  const auto section = section_of(results);
  EXPECT_THAT(facts(section, "/internal/largest"), ElementsAre(IsAbout(1.56e-4)));
  EXPECT_THAT(facts(section, "/time_minimum"), ElementsAre(IsNull()));
  EXPECT_THAT(facts(section, "/independent"), ElementsAre(IsNull()));
}

// One point per run; the recorded course of the best run of each formulation.
TEST(DriftSection, DrawsDriftsOverStepAndTime) {
  const auto drifts = section_of(three_formulations())["drifts"];
  ASSERT_EQ(drifts.size(), 1U);
  EXPECT_EQ(drifts[0]["points"]["drift"].size(), 12U);
  EXPECT_EQ(drifts[0]["points"]["formulations"],
            std::vector<std::string>({"integrated", "acceleration", "multiplier"}));
  ASSERT_EQ(drifts[0]["courses"].size(), 3U);
  const auto& best = drifts[0]["courses"][0];
  EXPECT_EQ(best["formulation"], "integrated");
  EXPECT_EQ(best["steps"], 512);
  EXPECT_EQ(best["t"], std::vector<double>({4.0, 8.0}));
  const double drift = 1e-3 * std::pow(drift_end / 512, 1.5);
  EXPECT_EQ(best["drift"], std::vector<double>({0.5 * drift, drift}));
}

TEST(DriftSection, DrawsNothingOfRounding) {
  Results results = results_without_runs();
  add_line(results, {with({}), 1e-16, 0.0, 1.0, 1e-6});
  EXPECT_FALSE(section_of(results).contains("drifts"));
}

TEST(DriftSection, IsThereOnlyWithDrift) {
  Results results = results_without_runs();
  results.records.push_back({.key = {.scene = {"pendulum"}, .scheme = "l1", .settings = {64}}, .steps = 64});
  EXPECT_TRUE(section_of(results).is_null());
}

}  // namespace
}  // namespace fde::bench
