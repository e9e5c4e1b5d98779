// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

class RecordedRuns : public testing::Test {
 protected:
  static RunKey key() { return {.scene = {"power"}, .scheme = "l1", .settings = {.resolution = 16}}; }
  static Record examination(const RunOutcome& how = {}, double error = 0.1) {
    Record run{.key = key(), .steps = 16, .end = 1.0, .ending = how, .ended_at = 1.0};
    run.values.set("error_end", error);
    return run;
  }
  static Record times(double least = 0.5) {
    Record run{.key = key()};
    run.timing.values.set("time_minimum", least);
    run.timing.values.set("time_median", 0.6);
    return run;
  }

  // What is recorded of the run: "nothing", or whether it is "complete" or "untimed".
  [[nodiscard]] std::string recorded() const {
    const auto run = ResultsFile(file_).recorded(key());
    return !run ? "nothing" : run->is_complete() ? "complete" : "untimed";
  }
  [[nodiscard]] std::string text() const { return content_of(file_); }
  void write(const std::string& content) const { std::ofstream(file_) << content; }

  // Changes a field of the file's session number `session`.
  void change(const std::string& field, int session) const {
    const std::string begin = fmt::format(R"("{}":")", field);
    auto changed = text();
    std::size_t place = 0;
    for (int i = 0; i <= session; ++i) place = changed.find(begin, place) + begin.size();
    write(changed.insert(place, "x"));
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "results.jsonl";
};

TEST_F(RecordedRuns, HaveNothingThenAllButTimesThenEverything) {
  EXPECT_EQ(recorded(), "nothing");
  ResultsFile(file_).append(examination());
  EXPECT_EQ(recorded(), "untimed");
  ResultsFile(file_).append_times(times());
  EXPECT_EQ(recorded(), "complete");
}

TEST_F(RecordedRuns, ThatDidNotFinishHaveNoTimes) {
  ResultsFile(file_).append(examination({SolveStatus::refused, "no"}));
  EXPECT_EQ(recorded(), "complete");
}

// A continued sweep examines such a run, so that the file becomes complete.
TEST_F(RecordedRuns, WithTimesAloneAreNotRecorded) {
  ResultsFile(file_).append_times(times());
  EXPECT_EQ(recorded(), "nothing");
  ResultsFile(file_).append(examination());
  EXPECT_EQ(recorded(), "untimed");
}

// A killed sweep leaves a prefix of the file: complete lines are kept.
TEST_F(RecordedRuns, OfAFileCutAnywhereAreThoseOfItsWholeLines) {
  {
    ResultsFile file(file_);
    file.append(examination());
    file.append_times(times());
  }
  const auto whole = text();
  const auto examined = whole.find('\n', whole.find("ending")) + 1;
  for (std::size_t length = whole.size() % 3; length <= whole.size(); length += 3) {
    write(whole.substr(0, length));
    const bool is_examined = length >= examined, is_timed = length == whole.size();
    EXPECT_EQ(read_results(file_).records.size(), is_examined ? 1 : 0) << length;
    EXPECT_EQ(recorded(), is_timed ? "complete" : is_examined ? "untimed" : "nothing") << length;
  }
}

TEST_F(RecordedRuns, TimesOfALaterSessionJoinTheirExamination) {
  ResultsFile(file_).append(examination());
  ResultsFile(file_).append_times(times());
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  const Record& run = runs.finished[0];
  EXPECT_EQ(run["error_end"], 0.1);
  EXPECT_EQ(run["time_minimum"], 0.5);
  EXPECT_EQ(run["time_median"], 0.6);
  EXPECT_EQ(run.session, 0U);
  EXPECT_EQ(run.last_session(), 1U) << "that of the times";
}

// Time and error of a run must be from the same build.
TEST_F(RecordedRuns, TimesOfAnotherBuildDoNotJoin) {
  ResultsFile(file_).append(examination());
  ResultsFile(file_).append_times(times());
  change("commit", 1);
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished[0]["time_minimum"], std::nullopt);
  EXPECT_EQ(runs.failed.size(), 0U);
  EXPECT_EQ(recorded(), "untimed");
}

// An examination gives the same numbers on every machine, a time does not.
TEST_F(RecordedRuns, OfAnotherMachineCountWithoutTheirTimes) {
  {
    ResultsFile file(file_);
    file.append(examination());
    file.append_times(times());
  }
  change("machine", 0);
  EXPECT_EQ(recorded(), "untimed");
  ResultsFile(file_).append_times(times(0.25));
  EXPECT_EQ(recorded(), "complete");
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished[0]["error_end"], 0.1);
  EXPECT_EQ(runs.finished[0]["time_minimum"], 0.25);
}

TEST_F(RecordedRuns, OfASlowerMachineThatRanOutOfTimeAreMadeAgain) {
  ResultsFile(file_).append(examination({SolveStatus::out_of_budget, ""}));
  EXPECT_EQ(recorded(), "complete");
  change("machine", 0);
  EXPECT_EQ(recorded(), "nothing");
}

// A later examination on another machine would otherwise remove the times of this one.
TEST_F(RecordedRuns, OfThisMachinePrecedeThoseOfAnother) {
  ResultsFile(file_).append(examination());
  ResultsFile(file_).append_times(times());
  ResultsFile(file_).append(examination({}, 0.2));
  change("machine", 2);
  EXPECT_EQ(recorded(), "complete");
}

TEST_F(RecordedRuns, TellTheNodeWhereItIsGiven) {
  ResultsFile(file_).append(examination());
  setenv("FDEBENCH_NODE", "node7", 1);
  ResultsFile(file_).append_times(times());
  setenv("FDEBENCH_NODE", "two\nlines", 1);
  EXPECT_THROW(ResultsFile{file_}, std::invalid_argument);
  unsetenv("FDEBENCH_NODE");
  const auto sessions = read_results(file_).sessions;
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[0].node, "");
  EXPECT_EQ(sessions[1].node, "node7");
}

TEST_F(RecordedRuns, ALaterExaminationReplacesTheEarlierWithItsTimes) {
  {
    ResultsFile file(file_);
    file.append(examination());
    file.append_times(times());
  }
  ResultsFile(file_).append(examination({}, 0.2));
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished[0]["error_end"], 0.2);
  EXPECT_EQ(runs.finished[0]["time_minimum"], std::nullopt) << "of the first examination";
}

}  // namespace
TEST(RunsOfResults, AreInOrderFromAnyOrder) {
  constexpr int count = 7;
  for (int first = 0; first < count; ++first) {
    Results results{.sessions = {{}}};
    for (int k = 0; k < count; ++k) {
      const int steps = 1 + (first + k) % count;
      Record run{.key = {.scene = {"relaxation", {}}, .scheme = "l1", .settings = {steps}}, .steps = steps};
      if (steps % 3 == 0) run.ending = {SolveStatus::non_finite};
      results.records.push_back(std::move(run));
    }
    const Runs runs = runs_of(std::move(results));
    const auto steps_of = [](const std::vector<Record>& of) {
      std::vector<int> steps;
      for (const Record& run : of) steps.push_back(run.steps);
      return steps;
    };
    EXPECT_THAT(steps_of(runs.finished), testing::ElementsAre(1, 2, 4, 5, 7)) << first;
    EXPECT_THAT(steps_of(runs.failed), testing::ElementsAre(3, 6)) << first;
  }
}

}  // namespace fde::bench
