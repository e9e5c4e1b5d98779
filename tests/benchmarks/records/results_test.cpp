// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>
#include <thread>

#include "benchmarks/records/results_file_test.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "support/message_of.hpp"

namespace fde::bench {
namespace {

class ResultsFiles : public ResultsFileTest {
 protected:
  static Record run(const std::string& scheme, int steps) {
    Record run{.key = key(scheme, steps), .steps = steps, .end = 1.0, .ended_at = 1.0};
    run.values.set("error_end", 0.1 / steps);
    return run;
  }

  static RunKey key(const std::string& scheme, int steps) {
    return {.scene = {"relaxation"}, .scheme = scheme, .settings = {.resolution = steps}};
  }
};

TEST_F(ResultsFiles, ReturnWhatWasAppended) {
  ResultsFile(file_).append(run("l1", 64));
  const auto results = read_results(file_);
  ASSERT_EQ(results.records.size(), 1U);
  EXPECT_EQ(results.records[0]["error_end"], 0.1 / 64);
  EXPECT_EQ(results.records[0].h(), 1.0 / 64);
  const ResultsFile again(file_);
  EXPECT_FALSE(again.recorded(key("l1", 64))->is_complete()) << "without times";
  EXPECT_FALSE(again.recorded(key("l1", 128)));
  EXPECT_FALSE(results.sessions.at(0).compiler.empty());
}

// Every setting is part of the key: another value of any member is another run.
TEST_F(ResultsFiles, TellRunsApartByTheirWholeKey) {
  ResultsFile(file_).append(run("l1", 64));
  const ResultsFile again(file_);
  const auto is_recorded_with = [&](const auto& change) {
    RunKey other = key("l1", 64);
    change(other);
    return again.recorded(other).has_value();
  };
  EXPECT_TRUE(is_recorded_with([](RunKey&) {}));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.scene.values["gamma"] = 0.5; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.scene.until = 1.0; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.scheme = "adams_pc"; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.settings.resolution = Tolerance{1e-6, 1e-9}; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.settings.grading = 2.0; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.settings.history = HistoryKind::direct; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.settings.newton_tolerance = 1e-8; }));
  EXPECT_FALSE(is_recorded_with([](RunKey& k) { k.settings.budget = 60.0; }));
}

TEST_F(ResultsFiles, KeepEveryMemberOfARun) {
  Record some = run("l1", 64);
  some.key = {.scene = {"knife_edge", {{"omega", 1.9}, {"formulation", "multiplier"}}, 5.0},
              .scheme = "l1",
              .settings = {Tolerance{1e-6, 1e-9}, 2.5, HistoryKind::direct, 1e-8, 60.0}};
  some.ending = RunOutcome{SolveStatus::non_finite, "at step 3, t = 0.5"};
  some.ended_at = 0.5;
  some.columns = {.names = {"x", "dx"}, .is_part = true};
  some.columns.values.set("error_end", {0.25, 1e-300});
  some.values.set("drift_internal", 1.0 / 3.0);
  some.values.set("expected_rate_end", -0.0);
  some.values.set("rhs_calls", 1e15);
  some.courses["drift_internal"] = {{0.1, 0.5}, {1e-3, 1.0 / 3.0}};
  some.timing.values.set("time_median", 4.9406564584124654e-324);
  ResultsFile(file_).append(some);
  const Record read = read_results(file_).records.back();
  EXPECT_EQ(read.key, some.key);
  EXPECT_EQ(read.steps, some.steps);
  EXPECT_EQ(read.end, some.end);
  EXPECT_EQ(read.ending, some.ending);
  EXPECT_EQ(read.ended_at, some.ended_at);
  EXPECT_EQ(read.columns, some.columns);
  EXPECT_EQ(read.courses, some.courses);
  for (const auto& [quantity, value] : some.values) EXPECT_EQ(read[quantity], value) << quantity;
  EXPECT_TRUE(std::signbit(*read["expected_rate_end"]));
  EXPECT_EQ(read.timing.values, some.timing.values);
  EXPECT_EQ(label_of(read.key.scene), "knife_edge:formulation=multiplier,omega=1.9,until=5");
}

// What is the default is left out, and whole numbers have no point.
TEST_F(ResultsFiles, HaveALineOfFewBytesForARun) {
  Record some = run("l1", 64);
  some.values.set("rhs_calls", 65.0);
  EXPECT_EQ(line_of(some), R"({"end":1,"ending":"finished","scene":"relaxation","scheme":"l1","steps":64,)"
                           R"("values":{"error_end":0.0015625,"rhs_calls":65}})"
                           "\n");
}

TEST_F(ResultsFiles, OfAnotherVersionAreRefusedAsSuch) {
  for (const std::string format : {"", R"("format":2,)"}) {
    write("{" + format + R"("session":{"commit":"c","compiler":"g","cores":4,"date":"d"}})" + "\n");
    EXPECT_EQ(message(file_),
              file_.string() + ": line 1: results of another version of fdebench, to be measured again");
  }
}

TEST_F(ResultsFiles, AreContinuedWithANewSession) {
  ResultsFile(file_).append(run("l1", 64));
  ResultsFile(file_).append(run("l1", 128));
  const auto results = read_results(file_);
  EXPECT_EQ(results.sessions.size(), 2U);
  EXPECT_EQ(results.records.back().session, 1U);
}

// Records belong to one build: with another commit runs are measured again.
TEST_F(ResultsFiles, OfAnotherBuildDoNotCount) {
  ResultsFile(file_).append(run("l1", 64));
  auto other = text();
  const std::string commit = R"("commit":")";
  other.insert(other.find(commit) + commit.size(), "x");
  write(other);
  EXPECT_FALSE(ResultsFile(file_).recorded(key("l1", 64)));
  EXPECT_EQ(read_results(file_).records.size(), 1U);
}

TEST_F(ResultsFiles, WithoutRunsAreLeftAsTheyAre) {
  ResultsFile(file_).append(run("l1", 64));
  const auto before = text();
  { const ResultsFile opened(file_); }
  EXPECT_EQ(text(), before);
}

// A killed sweep may leave any prefix of its file: complete runs are kept, the interrupted run is measured
// again.
TEST_F(ResultsFiles, CutAnywhereKeepTheirWholeRuns) {
  {
    ResultsFile file(file_);
    file.append(run("l1", 64));
    file.append(run("l1", 128));
  }
  const auto whole = text();
  for (std::size_t length = 30; length <= whole.size(); length += 7) {
    write(whole.substr(0, length));
    { ResultsFile(file_).append(run("l1", 256)); }
    const auto results = read_results(file_);
    EXPECT_EQ(results.records.back().steps, 256) << length;
    const auto lines = std::ranges::count(whole.substr(0, length), '\n');
    EXPECT_EQ(results.records.size(), std::max<std::size_t>(lines, 1)) << length;
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

TEST_F(ResultsFiles, LeaveOutARunWithImpossibleSteps) {
  ResultsFile(file_).append(run("l1", 64));
  for (const auto* steps : {"0", "-5", "64.5", "1000000000000"}) {
    auto changed = text();
    changed.replace(changed.find(R"("steps":64)"), 10, std::string(R"("steps":)") + steps);
    const auto other = folder_ / "changed.jsonl";
    std::ofstream(other) << changed;
    EXPECT_EQ(message(other), other.string() + ": line 2: steps = " + steps +
                                  ": must be a whole number from 1 to 2147483647 (left out)");
  }
}

// A run that is impossible is left out and named with its line, also in the middle of a file.
TEST_F(ResultsFiles, LeaveOutImpossibleRunsAndKeepTheOthers) {
  {
    ResultsFile file(file_);
    file.append(run("l1", 64));
    file.append(run("l1", 128));
  }
  const auto whole = text();
  const auto changed = [&](const std::string& from, const std::string& to) {
    const auto said = message_of_change(whole, from, to);
    EXPECT_EQ(read_results(file_).records.size(), 1U) << said;
    EXPECT_TRUE(ResultsFile(file_).recorded(key("l1", 128)));
    const std::string begin = ": line 2", end = " (left out)";
    EXPECT_TRUE(said.starts_with(begin) && said.ends_with(end)) << said;
    return said.substr(begin.size(), said.size() - begin.size() - end.size());
  };
  const std::string error = R"("error_end":0.0015625)", name = ": must be 1 to 100 bytes of UTF-8 that print";
  EXPECT_EQ(changed(error, R"("error_end":-1.0)"), ": error_end = -1: must be a finite number of at least 0");
  EXPECT_EQ(changed(error, R"("error_end":null)"), ": error_end = null: must be a number");
  EXPECT_EQ(changed(error, R"("error_end":1e999)"), " is not a row of fdebench results");
  EXPECT_EQ(changed(R"("error_end")", R"("")"), ": quantity = " + name);
  EXPECT_EQ(changed(R"("values":{"error_end":0.0015625})", R"("values":[1])"),
            " is not a row of fdebench results");
  EXPECT_EQ(changed(R"("scene":"relaxation")", R"("scene":"")"),
            ": scene = : must be 1 to 4096 bytes of UTF-8 that print");
  EXPECT_EQ(changed(R"("scheme":"l1")", R"("scheme":"")"), ": scheme = " + name);
  EXPECT_EQ(changed(R"("scheme")", R"("settings":{"until":-1},"scheme")").substr(0, 25),
            ": until = -1: must be a n");
  EXPECT_EQ(changed(R"("ending":"finished")", R"("ending":"")"), ": ending = " + name);
  EXPECT_EQ(changed(R"("ending":"finished",)", ""), " is not a row of fdebench results");
  EXPECT_EQ(changed(R"("end":1)", R"("end":-1)"), ": end = -1: must be a finite number of at least 0");
  const auto with_course = [&](const std::string& course) {
    return changed(R"("ending")", R"("courses":{"drift_internal":)" + course + R"(},"ending")");
  };
  EXPECT_EQ(with_course(R"({"t":[1,1],"value":[0,0]})"), ": course: its times must increase");
  EXPECT_EQ(with_course(R"({"t":[1,2],"value":[0]})"), ": course: has 1 values at 2 times");
  EXPECT_EQ(changed(R"("ending")", R"("wall_clock":true,"time":{},"ending")"),
            ": wall_clock: is allowed in times of other programs only");
  write(whole.substr(0, whole.find("error_end")) + whole.substr(whole.find('\n') + 1));
  EXPECT_EQ(message(file_), file_.string() + ": line 2 is not a row of fdebench results (left out)");
  write(whole.substr(whole.find('\n') + 1));
  EXPECT_EQ(message(file_), file_.string() + ": line 1: a run before the first session");
}

// A line that is no JSON, a description that is impossible and a lost session: what stands beside them is
// read and stays in the file when it is continued.
TEST_F(ResultsFiles, LoseAnOddLineAndNothingElse) {
  ResultsFile(file_).append(run("l1", 64));
  const auto session = text().substr(0, text().find('\n') + 1);
  const auto first = text();
  for (const std::string odd : {"garbage\n", "\n", "{}\n",
                                R"({"scene":{}})"
                                "\n",
                                R"({"scene":1})"
                                "\n"}) {
    write(first + odd);
    const auto reason = message(file_);
    EXPECT_EQ(reason, file_.string() + ": line 3 is not a row of fdebench results (left out)") << odd;
    ResultsFile(file_).append(run("l1", 128));
    EXPECT_TRUE(text().starts_with(first + odd)) << "what is left out stays in the file";
    const auto results = read_results(file_);
    EXPECT_EQ(results.records.size(), 2U) << odd;
    EXPECT_EQ(results.warning, reason);
  }
  auto lost = session;
  lost.replace(lost.find(R"("machine")"), 9, R"("engine")");
  write(first + lost + first.substr(session.size()) + first);
  EXPECT_EQ(message(file_),
            file_.string() + ": line 3 is not a row of fdebench results (left out, with 1 other line)");
  EXPECT_EQ(read_results(file_).records.size(), 2U);
}

// What the reader would leave out is not written.
TEST_F(ResultsFiles, AreNotGivenWhatNoReaderAccepts) {
  ResultsFile file(file_);
  file.append(run("l1", 64));
  const auto before = text();
  Record some = run("l1", 128);
  some.values.set("error_end", std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(file.append(some), UnreadableLine);
  some.values.set("error_end", -1.0);
  EXPECT_THROW(file.append(some), UnreadableLine);
  SceneDescription scene{.scene = {.id = "relaxation"}, .title = "Relaxation"};
  scene.solution = SampledSolution{.t = {0.0, 1.0, 1.0}, .columns = {{"y"}, {{1.0, 0.5, 0.25}}}};
  EXPECT_THROW(file.append(scene), UnreadableLine);
  EXPECT_EQ(text(), before);
  file.append(run("l1", 256));
  EXPECT_EQ(read_results(file_).records.size(), 2U);
}

// Results of another version may have what this build does not: it is read, and keeps its name.
TEST_F(ResultsFiles, WithUnknownNamesAreRead) {
  Record some = run("scheme_of_tomorrow", 64);
  some.key.scene = {"scene_of_tomorrow",
                    {{"gamma", 3.0}, {"form", "new"}, {"orders", std::vector{0.1, 0.2}}}};
  some.values.set("surprise", -1.0);
  some.courses["surprise"] = {{0.5, 1.0}, {-2.0, -1.0}};
  some.ending = RunOutcome{outcome_named("went_home"), "early"};
  ResultsFile(file_).append(some);
  const Record read = read_results(file_).records.front();
  EXPECT_EQ(read.key, some.key);
  EXPECT_EQ(read["surprise"], -1.0);
  EXPECT_EQ(read.courses, some.courses);
  EXPECT_EQ(sentence(read.ending), "went_home early");
}

TEST_F(ResultsFiles, HaveNoLineOfMoreThanAMebibyte) {
  ResultsFile(file_).append(run("l1", 64));
  const auto whole = text();
  std::ofstream(file_, std::ios::app) << std::string(std::size_t{1} << 21, ' ') << '\n';
  EXPECT_EQ(message(file_), file_.string() + ": line 3 is longer than 1048576 bytes");
}

// The settings of an external program are unknown. Its name may be any but a scheme's.
TEST_F(ResultsFiles, KeepTheTrajectoriesOfOtherPrograms) {
  Record some = run("numpy λ", 64);
  some.key.external = true;
  some.program = {"numpy", "1.24", "Python"};
  ResultsFile(file_).append(some);
  EXPECT_EQ(read_results(file_).records.back().key, some.key);
  EXPECT_EQ(read_results(file_).records.back().program, some.program);
  auto ours = text();
  for (auto at = ours.find("numpy λ"); at != std::string::npos; at = ours.find("numpy λ"))
    ours.replace(at, std::string("numpy λ").size(), "l1");
  write(ours);
  EXPECT_EQ(message(file_), file_.string() +
                                ": line 2: scheme = l1: must be another name than those of our schemes (left "
                                "out)");
}

TEST_F(ResultsFiles, ThatCannotBeWrittenAreNamed) {
  EXPECT_EQ(message(folder_ / "missing" / "r.jsonl"),
            (folder_ / "missing" / "r.jsonl").string() + ": cannot be written: No such file or directory");
  EXPECT_EQ(message(folder_), folder_.string() + ": cannot be read: is not a file");
}

// A limit on the file size simulates a full disk.
TEST_F(ResultsFiles, OnAFullDiskSaySoAndKeepTheirWholeRuns) {
  ResultsFile file(file_);
  file.append(run("l1", 64));
  const auto before = text();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit unlimited{};
  getrlimit(RLIMIT_FSIZE, &unlimited);
  const rlimit full{.rlim_cur = before.size() + 10, .rlim_max = unlimited.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  const auto message = message_of<std::system_error>([&] { file.append(run("l1", 128)); });
  setrlimit(RLIMIT_FSIZE, &unlimited);
  EXPECT_EQ(message, file_.string() + ": cannot be written: File too large");
  EXPECT_EQ(text(), before);
}

}  // namespace
}  // namespace fde::bench
