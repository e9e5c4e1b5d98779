// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/results_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "benchmarks/records/results_file_test.hpp"

namespace fde::bench {

class ResultsIndices : public ResultsFileTest {
 protected:
  static Record run(int steps, double error) {
    Record some{.key = {.scene = {"relaxation", {{"gamma", 0.5}}}, .scheme = "l1", .settings = {steps}},
                .steps = steps,
                .end = 1.0,
                .ended_at = 1.0};
    some.values.set("error_end", error);
    return some;
  }
  static Record timed(int steps, double seconds) {
    Record some{.key = run(steps, 1.0).key};
    some.timing.values.set("time_minimum", seconds);
    return some;
  }

  // Two builds examine the same run; the first one times it before and after that.
  void write_two_builds() const {
    ResultsFile(file_).append(SceneDescription{.scene = run(8, 1.0).key.scene, .title = "Relaxation"});
    ResultsFile(file_).append(run(8, 0.1));
    ResultsFile(file_).append(run(16, 0.05));
    ResultsFile(file_).append_times(timed(8, 1.0));
    const std::string commit = R"("commit":")", first = text();
    std::string other = first;
    for (auto at = other.find(commit); at != std::string::npos; at = other.find(commit, at + 1))
      other.insert(at + commit.size(), "x");
    write(other + first);  // by the other build, then by this one
    ResultsFile(file_).append_times(timed(8, 2.0));
  }
};

// A record that is read in its place is that of read_results().
TEST_F(ResultsIndices, PlaceWhatIsRead) {
  write_two_builds();
  const auto read = read_results(file_);
  const auto index = index_results(file_);
  const LinesByOffset lines(file_);
  ASSERT_EQ(index.runs.size(), 4U);
  EXPECT_EQ(index.sessions.size(), read.sessions.size());
  for (std::size_t i = 0; i < index.runs.size(); ++i) {
    const Record run = read_record(lines, index.runs[i]), &same = read.records[i];
    EXPECT_EQ(run.key, same.key) << i;
    EXPECT_EQ(run.values, same.values) << i;
    EXPECT_EQ(run.timing.values, same.timing.values) << i;
    EXPECT_EQ(run.timing.count, same.timing.count) << i;
    EXPECT_EQ(run.last_session(), same.last_session()) << i;
  }
  EXPECT_EQ(read.records[0]["time_minimum"], 1.0);
  EXPECT_EQ(read.records[2]["time_minimum"], 2.0);
}

TEST_F(ResultsIndices, KnowTheLatestRunsAndAllDescriptions) {
  write_two_builds();
  const auto index = index_results(file_);
  std::vector<bool> latest;
  for (const auto& run : index.runs) latest.push_back(run.is_latest);
  EXPECT_THAT(latest, testing::ElementsAre(false, false, true, true));
  ASSERT_EQ(index.scenes.size(), 1U);
  const auto& [scene, descriptions] = *index.scenes.begin();
  ASSERT_EQ(descriptions.size(), 2U);
  EXPECT_EQ(read_scene(LinesByOffset(file_), descriptions.back()).title, "Relaxation");
}

// A sweep looks up what it has appended itself.
TEST_F(ResultsIndices, OfASweepHaveItsOwnLines) {
  ResultsFile file(file_);
  file.append(run(8, 0.1));
  file.append_times(timed(8, 1.0));
  file.append(run(16, 0.05));
  ASSERT_TRUE(file.recorded(run(8, 0.1).key));
  EXPECT_EQ((*file.recorded(run(8, 0.1).key))["time_minimum"], 1.0);
  EXPECT_EQ((*file.recorded(run(16, 0.1).key))["error_end"], 0.05);
  EXPECT_FALSE(file.recorded(run(32, 0.1).key));
}

}  // namespace fde::bench
