// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "benchmarks/records/results_file_test.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"

namespace fde::bench {
namespace {

class ResultsFiles : public ResultsFileTest {
 protected:
  static std::vector<Record> rows(const std::string& scheme, int steps) {
    const Record row{.key = key(scheme, steps), .steps = steps, .h = 1.0 / steps};
    Record error = row, ending = row;
    error.quantity = "error_end";
    error.value = 0.1 / steps;
    ending.quantity = "ending";
    ending.unit = "t";
    ending.ending = RunOutcome{};
    return {error, ending};
  }

  static RunKey key(const std::string& scheme, int steps) {
    return {.scene = {"relaxation"}, .scheme = scheme, .setup = {.resolution = steps}};
  }
};

TEST_F(ResultsFiles, ReturnWhatWasAppended) {
  ResultsFile(file_).append(rows("l1", 64));
  const auto results = read_results(file_);
  ASSERT_EQ(results.records.size(), 2U);
  EXPECT_EQ(results.records[0].quantity, "error_end");
  EXPECT_EQ(results.records[0].value, 0.1 / 64);
  const ResultsFile again(file_);
  EXPECT_EQ(again.recorded(key("l1", 64)).amount(), RecordedAmount::all_but_times);
  EXPECT_EQ(again.recorded(key("l1", 128)).amount(), RecordedAmount::nothing);
  EXPECT_FALSE(results.sessions.at(0).compiler.empty());
}

// Every setting is part of the key: another value of any member is another run.
TEST_F(ResultsFiles, TellRunsApartByTheirWholeKey) {
  ResultsFile(file_).append(rows("l1", 64));
  const ResultsFile again(file_);
  const auto recorded_with = [&](const auto& change) {
    RunKey other = key("l1", 64);
    change(other);
    return again.recorded(other);
  };
  EXPECT_EQ(recorded_with([](RunKey&) {}).amount(), RecordedAmount::all_but_times);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.scene.values["gamma"] = 0.5; }).amount(),
            RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.scene.until = 1.0; }).amount(), RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.scheme = "adams_pc"; }).amount(), RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) {
              k.setup.resolution = Tolerance{1e-6, 1e-9};
            }).amount(),
            RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.setup.grading = 2.0; }).amount(), RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.setup.history = HistoryKind::direct; }).amount(),
            RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.setup.tolerance = 1e-8; }).amount(), RecordedAmount::nothing);
  EXPECT_EQ(recorded_with([](RunKey& k) { k.setup.budget = 60.0; }).amount(), RecordedAmount::nothing);
}

TEST_F(ResultsFiles, KeepEveryMemberOfARun) {
  auto some = rows("l1", 64);
  for (auto& row : some) {
    row.key = {.scene = {"knife_edge", {{"omega", 1.9}, {"formulation", "multiplier"}}, 5.0},
               .scheme = "l1",
               .setup = {Tolerance{1e-6, 1e-9}, 2.5, HistoryKind::direct, 1e-8, 60.0}};
  }
  some.back().ending = RunOutcome{SolveStatus::non_finite, "at step 3, t = 0.5"};
  some.back().columns = {.names = {"x", "dx"}, .is_part = true, .values = {{"error_end", {0.25, 1e-300}}}};
  ResultsFile(file_).append(some);
  const Record read = read_results(file_).records.back();
  EXPECT_EQ(read.key, some.back().key);
  EXPECT_EQ(read.ending, some.back().ending);
  EXPECT_EQ(read.columns, some.back().columns);
  EXPECT_EQ(label_of(read.key.scene), "knife_edge:formulation=multiplier,omega=1.9,until=5");
}

TEST_F(ResultsFiles, OfAnotherVersionAreRefusedAsSuch) {
  write(R"({"session":{"commit":"c","compiler":"g","cores":4,"date":"d"}})"
        "\n");
  EXPECT_EQ(message(file_),
            file_.string() + ": line 1: results of another version of fdebench, to be measured again");
}

// Version 0.2.0 called the baselines trivial_..., and a step too large for a growing mode outran_growth.
TEST_F(ResultsFiles, WithFormerNamesAreRead) {
  ResultsFile(file_).append(rows("l1", 64));
  std::string former = text();
  for (const auto& [name, replacement] :
       {std::pair<std::string, std::string>{R"("error_end")", R"("trivial_end")"},
        {R"("ending":"finished")", R"("ending":"outran_growth")"}})
    former.replace(former.find(name), name.size(), replacement);
  write(former);
  const auto results = read_results(file_);
  EXPECT_EQ(results.records.front().quantity, "baseline_end");
  EXPECT_EQ(results.records.back().ending->kind, SolveStatus::step_too_large);
}

TEST_F(ResultsFiles, AreContinuedWithANewSession) {
  ResultsFile(file_).append(rows("l1", 64));
  ResultsFile(file_).append(rows("l1", 128));
  const auto results = read_results(file_);
  EXPECT_EQ(results.sessions.size(), 2U);
  EXPECT_EQ(results.records.back().session, 1U);
}

// Records belong to one build: with another commit runs are measured again.
TEST_F(ResultsFiles, OfAnotherBuildDoNotCount) {
  ResultsFile(file_).append(rows("l1", 64));
  auto other = text();
  const std::string commit = R"("commit":")";
  other.insert(other.find(commit) + commit.size(), "x");
  write(other);
  EXPECT_EQ(ResultsFile(file_).recorded(key("l1", 64)).amount(), RecordedAmount::nothing);
  EXPECT_EQ(read_results(file_).records.size(), 2U);
}

TEST_F(ResultsFiles, WithoutRunsAreLeftAsTheyAre) {
  ResultsFile(file_).append(rows("l1", 64));
  const auto before = text();
  { const ResultsFile opened(file_); }
  EXPECT_EQ(text(), before);
}

// A killed sweep may leave any prefix of its file: complete runs are kept, the interrupted run is measured
// again.
TEST_F(ResultsFiles, CutAnywhereKeepTheirWholeRuns) {
  {
    ResultsFile file(file_);
    file.append(rows("l1", 64));
    file.append(rows("l1", 128));
  }
  const auto whole = text();
  for (std::size_t length = 30; length <= whole.size(); length += 7) {
    write(whole.substr(0, length));
    { ResultsFile(file_).append(rows("l1", 256)); }
    const auto results = read_results(file_);
    EXPECT_EQ(results.records.back().steps, 256) << length;
    EXPECT_EQ(results.records.size() % 2, 0U) << length;
  }
}

TEST_F(ResultsFiles, OfSomethingElseAreRefusedAndLeftAlone) {
  write("scene,scheme\nrelaxation,l1\n");
  EXPECT_EQ(message(file_), file_.string() + ": line 1 is not a row of fdebench results");
  EXPECT_EQ(text(), "scene,scheme\nrelaxation,l1\n");
  write("no line end");
  EXPECT_EQ(message(file_), file_.string() + ": line 1 is not a row of fdebench results");
  EXPECT_EQ(text(), "no line end");
}

TEST_F(ResultsFiles, BelongToOneRunAtATime) {
  const ResultsFile first(file_);
  EXPECT_EQ(message(file_), file_.string() + ": cannot be written: another run is writing to it");
}

// The second object waits for the lock until the first is destroyed.
TEST_F(ResultsFiles, AreWaitedFor) {
  std::optional<ResultsFile> first(std::in_place, file_);
  std::jthread closes([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    first.reset();
  });
  EXPECT_NO_THROW(ResultsFile(file_, std::chrono::seconds(20)));
}

TEST_F(ResultsFiles, LeaveOutARowWithImpossibleSteps) {
  ResultsFile(file_).append(rows("l1", 64));
  for (const auto* steps : {"0", "-5", "64.5", "1000000000000"}) {
    auto changed = text();
    changed.replace(changed.find(R"("steps":64)"), 10, std::string(R"("steps":)") + steps);
    const auto other = folder_ / "changed.jsonl";
    std::ofstream(other) << changed;
    EXPECT_EQ(message(other), other.string() + ": line 2: steps = " + steps +
                                  ": must be a whole number from 1 to 2147483647 (left out)");
  }
}

// A row that no run can have is left out and named with its line, also in the middle of a file; so is an
// incomplete row. Where it is the last of a measurement, the whole measurement is left out.
TEST_F(ResultsFiles, LeaveOutImpossibleRowsAndKeepTheOthers) {
  {
    ResultsFile file(file_);
    file.append(rows("l1", 64));
    file.append(rows("l1", 128));
  }
  const auto whole = text();
  const std::string rest = " (left out, with 1 other line)";
  const auto changed = [&](const std::string& from, const std::string& to) {
    auto text = message_of_change(whole, from, to);
    EXPECT_EQ(read_results(file_).records.size(), text.ends_with(rest) ? 2U : 3U) << text;
    EXPECT_EQ(ResultsFile(file_).recorded(key("l1", 128)).amount(), RecordedAmount::all_but_times);
    return text;
  };
  EXPECT_EQ(changed(R"("value":0.0015625)", R"("value":-1.0)"),
            ": line 2: error_end = -1: must be a finite number of at least 0 (left out)");
  EXPECT_EQ(changed(R"("value":0.0015625)", R"("value":null)"),
            ": line 2: error_end = null: must be a number (left out)");
  EXPECT_EQ(changed(R"("value":0.0015625)", R"("value":1e999)"),
            ": line 2 is not a row of fdebench results (left out)");
  const std::string name = ": must be 1 to 100 bytes of UTF-8 that print";
  EXPECT_EQ(changed(R"("error_end")", R"("")"), ": line 2: quantity = " + name + " (left out)");
  EXPECT_EQ(changed(R"("scene":"relaxation")", R"("scene":"")"),
            ": line 2: scene = : must be 1 to 4096 bytes of UTF-8 that print (left out)");
  EXPECT_EQ(changed(R"("scheme":"l1")", R"("scheme":"")"), ": line 2: scheme = " + name + " (left out)");
  EXPECT_EQ(changed(R"("settings":{})", R"("settings":{"until":-1})").substr(0, 33),
            ": line 2: until = -1: must be a n");
  EXPECT_EQ(changed(R"("unit":"")", R"("unit":"s")"),
            R"(: line 2: unit = s: must be "", that of error_end (left out))");
  EXPECT_EQ(changed(R"("ending":"finished")", R"("ending":"")"), ": line 3: ending = " + name + rest);
  EXPECT_EQ(changed(R"("ending":"finished",)", ""),
            ": line 3: ending: must be that of the quantity ending, and of no other" + rest);
  EXPECT_EQ(changed(R"("error_end")", R"("error_end","course":{"t":[1,1],"value":[0,0]})"),
            ": line 2: course: its times must increase (left out)");
  EXPECT_EQ(changed(R"("error_end")", R"("error_end","course":{"t":[1,2],"value":[0]})"),
            ": line 2: course: has 1 values at 2 times (left out)");
  EXPECT_EQ(changed(R"("last":true)", R"("lest":true)"),
            ": line 2: a measurement without its last row (left out, with 1 other line)");
  EXPECT_EQ(read_results(file_).records.size(), 2U);
  write(whole.substr(0, whole.find("error_end")) + whole.substr(whole.find('\n') + 1));
  EXPECT_EQ(message(file_), file_.string() + ": line 2 is not a row of fdebench results (left out)");
  write(whole.substr(whole.find('\n') + 1));
  EXPECT_EQ(message(file_), file_.string() + ": line 1: a row before the first session");
}

// A line that is no JSON, a description that is impossible and a lost session: what stands beside them is
// read and stays in the file when it is continued.
TEST_F(ResultsFiles, LoseAnOddLineAndNothingElse) {
  ResultsFile(file_).append(rows("l1", 64));
  const auto session = text().substr(0, text().find('\n') + 1);
  const auto first = text();
  for (const std::string odd : {"garbage\n", "\n", "{}\n",
                                R"({"scene":{}})"
                                "\n",
                                R"({"scene":1})"
                                "\n"}) {
    write(first + odd);
    const auto reason = message(file_);
    EXPECT_EQ(reason, file_.string() + ": line 4 is not a row of fdebench results (left out)") << odd;
    ResultsFile(file_).append(rows("l1", 128));
    EXPECT_TRUE(text().starts_with(first + odd)) << "what is left out stays in the file";
    const auto results = read_results(file_);
    EXPECT_EQ(results.records.size(), 4U) << odd;
    EXPECT_EQ(results.warning, reason);
  }
  auto lost = session;
  lost.replace(lost.find(R"("machine")"), 9, R"("engine")");
  write(first + lost + first.substr(session.size()) + first);
  EXPECT_EQ(message(file_),
            file_.string() + ": line 4 is not a row of fdebench results (left out, with 2 other lines)");
  EXPECT_EQ(read_results(file_).records.size(), 4U);
}

// What the reader would leave out is not written.
TEST_F(ResultsFiles, AreNotGivenWhatNoReaderAccepts) {
  ResultsFile file(file_);
  file.append(rows("l1", 64));
  const auto before = text();
  auto some = rows("l1", 128);
  some.front().value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(file.append(some), UnreadableLines);
  some.front().value = -1.0;
  EXPECT_THROW(file.append(some), UnreadableLines);
  SceneDescription scene{.scene = {.id = "relaxation"}, .title = "Relaxation"};
  scene.solution = SampledSolution{.t = {0.0, 1.0, 1.0}, .columns = {{"y"}, {{1.0, 0.5, 0.25}}}};
  EXPECT_THROW(file.append(scene), UnreadableLines);
  EXPECT_EQ(text(), before);
  file.append(rows("l1", 256));
  EXPECT_EQ(read_results(file_).records.size(), 4U);
}

// Results of another version may have what this build does not: it is read, and keeps its name.
TEST_F(ResultsFiles, WithUnknownNamesAreRead) {
  auto some = rows("scheme_of_tomorrow", 64);
  for (auto& row : some) {
    row.key.scene = {"scene_of_tomorrow",
                     {{"gamma", 3.0}, {"form", "new"}, {"orders", std::vector{0.1, 0.2}}}};
  }
  some.front().quantity = "surprise";
  some.front().unit = "m";
  some.front().value = -1.0;
  some.front().course = {{0.5, 1.0}, {-2.0, -1.0}};
  some.back().ending = RunOutcome{outcome_named("went_home"), "early"};
  ResultsFile(file_).append(some);
  const auto read = read_results(file_).records;
  EXPECT_EQ(read.front().key, some.front().key);
  EXPECT_EQ(read.front().quantity, "surprise");
  EXPECT_EQ(read.front().course, some.front().course);
  EXPECT_EQ(sentence(*read.back().ending), "went_home early");
}

TEST_F(ResultsFiles, HaveNoLineOfMoreThanAMebibyte) {
  ResultsFile(file_).append(rows("l1", 64));
  const auto whole = text();
  std::ofstream(file_, std::ios::app) << std::string(std::size_t{1} << 21, ' ') << '\n';
  EXPECT_EQ(message(file_), file_.string() + ": line 4 is longer than 1048576 bytes");
}

// The settings of an external program are unknown. Its name may be any but a scheme's.
TEST_F(ResultsFiles, KeepTheTrajectoriesOfOtherPrograms) {
  auto some = rows("numpy λ", 64);
  for (auto& row : some) row.key.external = true;
  ResultsFile(file_).append(some);
  EXPECT_EQ(text().find("grid"), std::string::npos);
  EXPECT_EQ(read_results(file_).records.back().key, some.back().key);
  auto ours = text();
  for (auto at = ours.find("numpy λ"); at != std::string::npos; at = ours.find("numpy λ"))
    ours.replace(at, std::string("numpy λ").size(), "l1");
  write(ours);
  EXPECT_EQ(message(file_), file_.string() +
                                ": line 2: scheme = l1: must be another name than those of our schemes (left "
                                "out, with 1 other line)");
}

TEST_F(ResultsFiles, ThatCannotBeWrittenAreNamed) {
  EXPECT_EQ(message(folder_ / "missing" / "r.jsonl"),
            (folder_ / "missing" / "r.jsonl").string() + ": cannot be written: No such file or directory");
  EXPECT_EQ(message(folder_), folder_.string() + ": cannot be read: is not a file");
}

// A limit on the file size simulates a full disk.
TEST_F(ResultsFiles, OnAFullDiskSaySoAndKeepTheirWholeRuns) {
  ResultsFile file(file_);
  file.append(rows("l1", 64));
  const auto before = text();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit unlimited{};
  getrlimit(RLIMIT_FSIZE, &unlimited);
  const rlimit full{.rlim_cur = before.size() + 10, .rlim_max = unlimited.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  std::string message;
  try {
    file.append(rows("l1", 128));
  } catch (const std::system_error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &unlimited);
  EXPECT_EQ(message, file_.string() + ": cannot be written: File too large");
  EXPECT_EQ(text(), before);
}

}  // namespace
}  // namespace fde::bench
