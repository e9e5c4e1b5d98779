// SPDX-License-Identifier: MIT
// What results files say of their scenes.

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "benchmarks/records/results_file_test.hpp"
#include "fdebench/benchmarks/files/lines.hpp"

namespace fde::bench {
namespace {

SceneDescription description() {
  return {.scene = {.id = "relaxation", .values = {{"gamma", 0.25}}},
          .title = "Relaxation",
          .source = "a book",
          .equations = {{"D(y, gamma)", "-y"}},
          .parameters = {{"gamma", "0.25", "the order", true}},
          .discontinuities = {{"gamma", "all tends to nothing"}},
          .evidence = "two methods",
          .reference_seconds = 0.5,
          .trial = TrialRuns{3, "Stiff", 4096, {1e-6, 1e-9}},
          .solution = SampledSolution{.t = {0.0, 1.0},
                                      .columns = {{"y", "z"}, {{1.0, std::nullopt}, {1.0, 2.0}}},
                                      .bound = 1e-15,
                                      .energy = {{"energy"}, {{2.0, 1.0}}},
                                      .motion = {.names = {"y", "z"}}}};
}

Record run() {
  return {.key = {.scene = description().scene, .scheme = "l1", .settings = {.resolution = 64}},
          .steps = 64,
          .end = 1.0};
}

class DescribedScenes : public ResultsFileTest {};

TEST_F(DescribedScenes, AreReturnedByTheFile) {
  {
    ResultsFile file(file_);
    EXPECT_FALSE(file.describes(description().scene));
    file.append(description());
    EXPECT_TRUE(file.describes(description().scene));
    file.append(run());
  }
  const auto results = read_results(file_);
  EXPECT_EQ(results.scenes, std::vector{description()});
  EXPECT_EQ(results.records.size(), 1U);
  EXPECT_TRUE(ResultsFile(file_).describes(description().scene));
}

TEST_F(DescribedScenes, LeaveOutWhatALineHasNoRoomFor) {
  const std::string half(most_line_bytes / 2, 'x');
  auto scene = description();
  scene.parameters[0].meaning = half;
  const auto returned = [&] {
    std::filesystem::remove(file_);
    ResultsFile(file_).append(scene);
    return read_results(file_).scenes;
  };
  EXPECT_EQ(returned(), std::vector{scene});
  scene.parameters[0].value = half;
  auto kept = scene;
  kept.parameters.clear();
  EXPECT_EQ(returned(), std::vector{kept});
  scene.equations = {{half, half}};
  kept.equations.clear();
  EXPECT_EQ(returned(), std::vector{kept});
  const int times = 200'000;
  scene.solution = SampledSolution{.columns = {{"y"}, {{}}}};
  for (int i = 0; i < times; ++i) {
    scene.solution->t.push_back(i);
    scene.solution->columns.values[0].emplace_back(i);
  }
  kept.solution.reset();
  EXPECT_EQ(returned(), std::vector{kept});
}

TEST_F(DescribedScenes, LeaveOutValuesThatNoChartHasRoomFor) {
  auto scene = description();
  scene.solution->columns.values[1][1] = -1e308;
  ResultsFile(file_).append(scene);
  scene.solution->columns.values[1][1].reset();
  EXPECT_EQ(read_results(file_).scenes, std::vector{scene});
}

TEST_F(DescribedScenes, AreLeftOutIfTheyAreMalformed) {
  ResultsFile(file_).append(description());
  const auto whole = text();
  const auto changed = [&](const std::string& from, const std::string& to) {
    return message_of_change(whole, from, to);
  };
  EXPECT_EQ(changed(R"("title":"Relaxation")", R"("title":"a\u0007")"),
            ": line 2: title = a\a: must be UTF-8 that prints (left out)");
  EXPECT_EQ(changed(R"("title":"Relaxation")", R"("name":1)"),
            ": line 2 is not a row of fdebench results (left out)");
  EXPECT_EQ(changed(R"("reference_seconds":0.5)", R"("reference_seconds":-1)"),
            ": line 2: reference_seconds = -1: must be a finite number of at least 0 (left out)");
  EXPECT_EQ(changed(R"("t":[0.0,1.0])", R"("t":[0.0,0.0])"),
            ": line 2: solution: its times must increase (left out)");
  EXPECT_EQ(changed(R"("t":[0.0,1.0])", R"("t":[0.0,1.0,2.0])"),
            ": line 2: solution: has 2 values at 3 times (left out)");
  EXPECT_EQ(changed(R"("steps":4096)", R"("steps":0)"),
            ": line 2: trial = 0: must be a finite number of at least 1 (left out)");
  EXPECT_EQ(changed(R"("motion":{"columns":["y","z"])", R"("motion":{"columns":["y"])"),
            ": line 2: motion = 1 columns: must be 2 or 3 columns (left out)");
  EXPECT_EQ(changed(R"("motion":{"columns":["y","z"])", R"("motion":{"columns":["y","x"])"),
            ": line 2: motion = x: must be a column of the solution, or have values (left out)");
  EXPECT_EQ(changed(R"("columns":["y","z"],"energy")", R"("columns":["y"],"energy")"),
            ": line 2: solution: has 2 values at 1 times (left out)");
  write(whole.substr(whole.find('\n') + 1));
  EXPECT_EQ(message(file_), file_.string() + ": line 1: a scene before the first session");
}

}  // namespace
}  // namespace fde::bench
