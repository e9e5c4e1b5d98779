// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/study_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/study/study_testing.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "support/command_output.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

RunKey run_of(const SceneVariant& scene, int steps) {
  return {.scene = scene.key(), .scheme = "l1", .settings = {.resolution = steps}};
}

// Scenes that take 1, 2, ..., 10 seconds; the first also in a second family.
struct PlannedStudy {
  Study study = study_of(
      "[[family]]\nscene = \"relaxation\"\nparameters.gamma = {from = 0.1, to = 1, count = 10}\n"
      "[[family]]\nscene = \"relaxation\"\nsteps = 9\nparameters.gamma = 0.1\n");
  PlannedScenes scenes = [this] {
    Forecast expected;
    double seconds = 0.0;
    for (const auto& scene : study.families[0].scenes) expected[run_of(scene, 8)] = {seconds += 1.0, 0.5};
    expected[run_of(study.families[1].scenes[0], 9)] = {0.0, 0.0};
    return planned_scenes(expected);
  }();
};

TEST(StudyShards, TakeAboutTheSameTimeAndAreTheStudyTogether) {
  const PlannedStudy planned;
  EXPECT_EQ(sum_of(planned.scenes).runs, 11U);
  EXPECT_DOUBLE_EQ(sum_of(planned.scenes).seconds.total(), 60.0);
  const auto shards = shards_of(planned.study, planned.scenes, 3);
  ASSERT_EQ(shards.size(), 3U);
  std::multiset<std::string> all;
  std::size_t runs = 0;
  for (const auto& shard : shards) {
    EXPECT_NEAR(shard.work.seconds.total(), 20.0, 1.5);
    runs += shard.work.runs;
    const auto points = points_of(shard.study);
    all.insert(points.begin(), points.end());
    if (shard.study.families.size() == 2) {
      EXPECT_THAT(points, testing::Contains("gamma=0.1").Times(2)) << "a scene is in one shard";
    }
  }
  EXPECT_EQ(runs, 11U);
  const auto whole = points_of(planned.study);
  EXPECT_EQ(all, std::multiset<std::string>(whole.begin(), whole.end()));
}

TEST(StudyShards, AreNotMoreThanTheScenes) {
  const PlannedStudy planned;
  EXPECT_EQ(shards_of(planned.study, planned.scenes, 100).size(), 10U);
}

// The lines of the runs without times and without order.
std::multiset<std::string> untimed(const std::filesystem::path& file) {
  std::multiset<std::string> lines;
  for (Record& run : read_results(file).records) {
    run.timing = {};
    lines.insert(line_of(run));
  }
  return lines;
}

// The names and contents of the files of a folder.
std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    found[entry.path().filename()] = content_of(entry.path());
  return found;
}

TEST(StudyPlans, ReplaceAnEarlierPlanWholeOrNotAtAll) {
  const PlannedStudy planned;
  const TemporaryFolder folder;
  write_plan(planned.study, shards_of(planned.study, planned.scenes, 3), folder.path());
  const auto earlier = contents(folder.path());
  EXPECT_EQ(earlier.size(), 4U);
  const auto shards = shards_of(planned.study, planned.scenes, 2);
  {
    const FullDisk full(10);
    EXPECT_THROW(write_plan(planned.study, shards, folder.path()), std::invalid_argument);
  }
  EXPECT_EQ(contents(folder.path()), earlier);
  write_plan(planned.study, shards, folder.path());
  EXPECT_EQ(contents(folder.path()).size(), 3U);
}

TEST(Studies, HaveTheRunsOfTheirShardsMerged) {
  const TemporaryFolder folder;
  folder.write("eq/decay.toml",
               "end = 1\n[parameters]\nq = 0.5\n[unknown.y]\norder = \"q\"\nrhs = \"-y\"\ninitial = [1]\n");
  folder.write("s.toml",
               "schemes = [\"l1\", \"spectral_collocation\"]\nsteps = [4, 8]\naccuracies = 1e-3\nrepeat = 1\n"
               "[[family]]\nscene = \"eq/decay.toml\"\nparameters.q = [0.3, 0.6]\n"
               "[[family]]\nscene = \"relaxation\"\nschemes = \"bdf2\"\ndraws = 5\n"
               "parameters.gamma = {distribution = \"uniform\", from = 0.2, to = 0.9}\n");
  EXPECT_THAT(printed(fdebench(
                  {"study", "plan", folder.file("s.toml"), "--shards", "3", "--out", folder.file("parts")})),
              HasSubstr("16 runs of 7 scenes\n"));
  EXPECT_EQ(fdebench({"run", "--study", folder.file("s.toml"), "--out", folder.file("whole.jsonl")}).code, 0);
  nlohmann::json plan;
  std::ifstream(folder.file("parts/plan.json")) >> plan;
  EXPECT_EQ(plan["study"], folder.file("s.toml"));
  std::vector<std::string> merge{"merge"};
  int runs = 0;
  for (const auto& shard : plan["shards"]) {
    const auto results = folder.file(shard["file"].get<std::string>() + ".jsonl");
    const auto file = "parts/" + shard["file"].get<std::string>();
    expect_success(fdebench({"run", "--study", folder.file(file), "--out", results}));
    merge.push_back(results);
    runs += shard["runs"].get<int>();
  }
  EXPECT_EQ(merge.size(), 4U);
  EXPECT_EQ(runs, 16);
  merge.insert(merge.end(), {"--out", folder.file("merged.jsonl")});
  EXPECT_EQ(fdebench(merge).code, 0);
  EXPECT_EQ(untimed(folder.file("merged.jsonl")), untimed(folder.file("whole.jsonl")));
  EXPECT_EQ(read_results(folder.file("merged.jsonl")).scenes.size(), 7U);
  EXPECT_FALSE(read_results(folder.file("whole.jsonl")).scenes.front().solution)
      << "families do without solutions";
}

}  // namespace
}  // namespace fde::bench
