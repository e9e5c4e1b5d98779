// SPDX-License-Identifier: MIT
// External programs in a sweep. The scene `power` with p = 2 has the solution t^2.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// Shell code: prints the output times of the task file $1, one a line.
constexpr auto print_times = R"(sed -n '/"times"/,/]/p' "$1" | tr -d ' ],' | grep '^[0-9]')";

class ExternalRuns : public testing::Test {
 protected:
  // A program that runs this script.
  [[nodiscard]] std::string program(const std::string& script, const std::string& name = "mine") const {
    folder_.write(name + ".sh", script);
    return fmt::format("{}=sh '{}'", name, folder_.file(name + ".sh"));
  }

  // A program that runs the lines `first`, then prints t^2 + 1e-3 at the output times; it counts its starts.
  [[nodiscard]] std::string square(const std::string& first = "", const std::string& name = "mine") const {
    return program(fmt::format("echo >> '{}'; {}\n{} | awk 'BEGIN {{ print \"t,y\" }} {{ printf "
                               "\"%s,%.17g\\n\", $1, $1 * $1 + 1e-3 }}'\n",
                               folder_.file("starts"), first, print_times),
                   name);
  }

  [[nodiscard]] CommandOutput run(const std::string& external,
                                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run", "--scene",    "power:p=2", "--steps", "8",     "--repeat",
                                   "2",   "--external", external,    "--out",   results_};
    words.insert(words.end(), more.begin(), more.end());
    return fdebench(words);
  }

  [[nodiscard]] std::vector<Record> runs() const { return read_results(results_).records; }

  [[nodiscard]] std::vector<double> values(const std::string& quantity) const {
    std::vector<double> found;
    for (const Record& run : runs()) {
      if (const auto value = run[quantity]) found.push_back(*value);
    }
    return found;
  }

  // The ending of the single run of a script.
  [[nodiscard]] std::string ending(const std::string& script,
                                   const std::vector<std::string>& more = {}) const {
    std::filesystem::remove(results_);
    expect_success(run(program(script), more));
    const auto all = runs();
    if (all.empty()) return "no run";
    EXPECT_EQ(all.front().key.scheme, "mine");
    EXPECT_TRUE(all.front().key.external);
    return sentence(all.front().ending);
  }

  [[nodiscard]] std::size_t starts() const { return content_of(folder_.path() / "starts").size(); }

  const TemporaryFolder folder_;
  const std::string results_ = folder_.file("results.jsonl");
};

TEST_F(ExternalRuns, AreJudgedAndTimedLikeSchemes) {
  ASSERT_EQ(run(square(), {"--scheme", "l1"}).code, 0);
  const auto all = runs();
  ASSERT_EQ(all.size(), 2U);
  const Record& last = all.back();
  EXPECT_TRUE(last.key.external);
  EXPECT_NEAR(*last["error_maximum"], 1e-3, 1e-15);
  EXPECT_EQ(last.key.scheme, "mine");
  EXPECT_EQ(last.steps, 8);
  EXPECT_DOUBLE_EQ(last.h(), 0.125);
  EXPECT_TRUE(last.timing.wall_clock);
  EXPECT_GT(*last["time_minimum"], 0.0);
  EXPECT_EQ(starts(), 3U);  // examined once, timed twice
}

TEST_F(ExternalRuns, TellTheTimeOfTheirSolve) {
  ASSERT_EQ(run(square("echo '# seconds: 0.25'")).code, 0);
  EXPECT_THAT(values("time_median"), ElementsAre(0.25));
  EXPECT_FALSE(runs().front().timing.wall_clock);
}

TEST_F(ExternalRuns, StandBesideSchemesOrAlone) {
  ASSERT_EQ(run(square()).code, 0);
  EXPECT_EQ(runs().size(), 1U);
  ASSERT_EQ(run(square(), {"--external", square("", "other"), "--scheme", "l1"}).code, 0);
  EXPECT_EQ(runs().size(), 3U);
}

TEST_F(ExternalRuns, AreNotMadeAgainWhenTheSweepIsContinued) {
  ASSERT_EQ(run(square()).code, 0);
  const auto before = starts();
  ASSERT_EQ(run(square()).code, 0);
  EXPECT_EQ(starts(), before);
  ASSERT_EQ(run(square(), {"--steps", "8,16"}).code, 2);  // given twice
  ASSERT_EQ(fdebench({"run", "--scene", "power:p=2", "--steps", "8,16", "--repeat", "2", "--external",
                      square(), "--out", results_})
                .code,
            0);
  EXPECT_EQ(starts(), 2 * before);
}

TEST_F(ExternalRuns, AreListedByADryRunAndNotStarted) {
  const auto answer = printed(run(square(), {"--dry-run", "--shard", "1/1"}));
  EXPECT_THAT(answer, HasSubstr("power:p=2 mine N = 8  "));
  EXPECT_THAT(answer, HasSubstr("1 runs, about "));
  EXPECT_EQ(starts(), 0U);
  ASSERT_EQ(run(square(), {"--shard", "1/1"}).code, 0);
  EXPECT_THAT(run(square(), {"--dry-run"}).out, HasSubstr("0 runs"));
}

// Another grid is another run, with other output times.
TEST_F(ExternalRuns, AreAskedForTheGrid) {
  ASSERT_EQ(run(square()).code, 0);
  ASSERT_EQ(run(square(fmt::format("grep -q '\"grid\": \"graded:2.0\"\\|\"grid\": \"graded:2\"' \"$1\" && "
                                   "{} | grep -q '^0.015625$' || exit 9",
                                   print_times)),
                {"--grid", "graded:2"})
                .code,
            0);
  EXPECT_THAT(values("error_end"), testing::SizeIs(2));
  EXPECT_EQ(runs().back().key.settings.grading, 2.0);
}

TEST_F(ExternalRuns, AreToldTheWholeTask) {
  const auto copy = folder_.file("task.json");
  ASSERT_EQ(run(square(R"(cp "$1" )" + copy)).code, 0);
  const auto text = content_of(copy);
  for (const auto* part :
       {R"("format": 1)", R"("scene": "power")", R"("label": "power:p=2")", R"("gamma": 0.5)", R"("p": 2.0)",
        R"("order": 0.5)", R"("side": "left")", R"("end_time": 1.0)", R"("steps": 8)", R"("grid": "uniform")",
        R"("budget": 600.0)", "0.125"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(ExternalRuns, AreToldTheEquationsOfAFile) {
  folder_.write("square.toml",
                "end = 1\n[parameters]\na = 2\n[unknown.y]\nterms = [[\"1/a\", 1], [0.5, 0.5]]\n"
                "rhs = \"t - y*step(0.5 - t)\"\ninitial = [0]\n[[jump]]\nat = 0.5\n");
  const auto copy = folder_.file("task.json");
  const auto answer =
      fdebench(std::vector<std::string>{"run", "--scene", folder_.file("square.toml") + ":a=4", "--steps",
                                        "8", "--external", program("cp \"$1\" " + copy), "--out", results_});
  ASSERT_EQ(answer.code, 0) << answer.err;
  const auto task = nlohmann::json::parse(std::ifstream(copy));
  EXPECT_EQ(task["parameters"]["a"], 4.0);
  EXPECT_EQ(task["jumps"], std::vector<double>{0.5});
  EXPECT_EQ(task["equations"], nlohmann::json::parse(R"json([{"unknown": "y", "initial": ["0"],
      "terms": [["1/a", "1"], ["0.5", "0.5"]], "rhs": "t - y*step(0.5 - t)"
}])json"));
}

// sum c_k D^(a_k) x = rhs as in the file, and as rows with their Jacobian; x is the first row, D^0.5 x the
// second.
TEST_F(ExternalRuns, AreToldTheRowsAsFormulas) {
  folder_.write("rows.toml",
                "end = 1\n[unknown.x]\nterms = [[2, 1], [0.5, 0.5]]\nrhs = \"-x^3\"\ninitial = [1]\n");
  const auto copy = folder_.file("task.json");
  const auto answer =
      fdebench(std::vector<std::string>{"run", "--scene", folder_.file("rows.toml"), "--steps", "8",
                                        "--external", program("cp \"$1\" " + copy), "--out", results_});
  ASSERT_EQ(answer.code, 0) << answer.err;
  const auto task = nlohmann::json::parse(std::ifstream(copy));
  EXPECT_EQ(task["system"]["columns"], (std::vector<std::string>{"x", "D(x,0.5)"}));
  EXPECT_EQ(task["system"]["rhs"], (std::vector<std::string>{"y2", "(((-((y1*y1)*y1))-(0.5*y2))/2.0)"}));
  EXPECT_EQ(task["system"]["jacobian"][0], (std::vector<std::string>{"0.0", "1.0"}));
  EXPECT_EQ(task["system"]["jacobian"][1][1], "(-0.25)");
  EXPECT_EQ(task["multi_term"], nlohmann::json::parse(R"json([{"unknown": "y1", "coefficients": [0.5, 2.0],
      "orders": [0.5, 1.0], "initial": [1.0], "rhs": "(-((y1*y1)*y1))"}])json"));
}

// 2 D^1 x = -D^0.5 x + ... is not a multi-term equation whose right-hand side is a function of t and x.
TEST_F(ExternalRuns, AreToldNoMultiTermEquationWithDerivativesOnTheRight) {
  folder_.write("rows.toml",
                "end = 1\n[unknown.x]\nterms = [[2, 1], [0.5, 0.5]]\nrhs = \"-D(x,0.5)^2\"\ninitial = [1]\n");
  const auto copy = folder_.file("task.json");
  ASSERT_EQ(fdebench({"run", "--scene", folder_.file("rows.toml"), "--steps", "8", "--external",
                      program("cp \"$1\" " + copy), "--out", results_})
                .code,
            0);
  const auto task = nlohmann::json::parse(std::ifstream(copy));
  EXPECT_TRUE(task.contains("system"));
  EXPECT_FALSE(task.contains("multi_term"));
}

TEST_F(ExternalRuns, TellTheirFirstSolveApartFromLaterOnes) {
  ASSERT_EQ(
      run(square(
              "printf '# code: mine 1.2\\n# language: awk\\n# first: 0.5\\n# seconds: 0.25 0.125 0.375\\n'"))
          .code,
      0);
  EXPECT_THAT(values("time_median"), ElementsAre(0.25));
  EXPECT_THAT(values("time_minimum"), ElementsAre(0.125));
  EXPECT_THAT(values("time_setup"), ElementsAre(0.25));
  EXPECT_THAT(values("time_start"), ElementsAre(0.0));  // the process was shorter than the solves it tells
  EXPECT_EQ(runs().front().program, (ProgramFacts{"mine", "1.2", "awk"}));
}

// t^2 + 1e-3 at times that nobody requested.
TEST_F(ExternalRuns, AreJudgedAtTheirOwnTimes) {
  EXPECT_EQ(ending("echo '# times: own'; echo t,y; echo 0.3,0.091; echo 1,1.001"), "finished");
  ASSERT_EQ(values("error_maximum").size(), 1U);
  EXPECT_NEAR(values("error_maximum")[0], 1e-3, 1e-15);
  EXPECT_EQ(ending("echo '# times: own'; echo t,y; echo 0.3,0.091"),
            "the program failed: standard output: has no row at t = 1");
}

// What a program says of itself is recorded also where it refuses the scene or writes no trajectory.
TEST_F(ExternalRuns, AreNamedWhereTheyFail) {
  EXPECT_EQ(ending("echo '# code: mine'; echo takes no powers >&2; exit 77"), "refused: takes no powers");
  EXPECT_EQ(runs().back().program, (ProgramFacts{"mine", "", ""}));
  EXPECT_THAT(ending("echo '# code: mine'; echo '# language: sh'; echo t,z"), HasSubstr("no such column"));
  EXPECT_EQ(runs().back().program, (ProgramFacts{"mine", "", "sh"}));
}

TEST_F(ExternalRuns, EndWithAReasonWhenTheyFail) {
  EXPECT_EQ(ending("echo tensors are gone >&2; exit 3"), "the program failed: exit code 3: tensors are gone");
  EXPECT_EQ(ending("kill -SEGV $$"), "the program failed: ended by signal 11 (Segmentation fault)");
  EXPECT_EQ(ending("printf '\\377\\033[2J\\n' >&2; exit 1"), "the program failed: exit code 1: ??[2J");
  EXPECT_EQ(ending("echo takes no powers >&2; exit 77"), "refused: takes no powers");
  EXPECT_EQ(ending("sleep 100 & sleep 100", {"--budget", "0.3"}), "out of its budget of time after 0.3 s");
  EXPECT_EQ(ending("yes"), "the program failed: it wrote more than 268435456 bytes");
}

TEST_F(ExternalRuns, EndWithAReasonWhenTheyWriteNoTrajectory) {
  const std::string begin = "the program failed: standard output: ";
  EXPECT_EQ(ending("exit 0"), begin + "line 1: there is no header");
  EXPECT_THAT(ending("echo t,z; echo 0,0; echo 1,1"), HasSubstr(begin + "line 1: column z: no such column"));
  EXPECT_EQ(ending("echo t,y; echo 0,0; echo 1,1"), begin + "has no row at t = 0.125");
  EXPECT_EQ(ending("echo t,y; echo 0,zero"), begin + "line 2: y = zero: must be a number");
  EXPECT_EQ(ending("echo '# seconds: -1'; echo t,y; echo 1,1"),
            begin + "line 1: seconds = -1: must be a finite number above 0");
  EXPECT_EQ(ending("echo '# times: mine'; echo t,y; echo 1,1"), begin + "line 1: times = mine: must be own");
  EXPECT_EQ(ending("echo '# first: 1'; echo '# first: 2'; echo t,y; echo 1,1"),
            begin + "line 2: first is given twice");
  EXPECT_EQ(ending("head -c 3000000 /dev/zero"), begin + "line 1 is longer than 1048576 bytes");
  EXPECT_EQ(ending("echo t,y; echo 0,0; echo 0.125,nan"), "not finite at t = 0.125");
}

TEST_F(ExternalRuns, LeaveTheOtherRunsAlone) {
  ASSERT_EQ(run(program("kill -KILL $$"), {"--scheme", "l1", "--external", square("", "good")}).code, 0);
  std::vector<std::string> finished;
  for (const Record& run : runs()) {
    if (run.ending.kind == SolveStatus::finished) finished.push_back(run.key.scheme);
  }
  EXPECT_THAT(finished, ElementsAre("l1", "good"));
}

// The scheme has a larger error, so the program is the only option; its time is marked as wall time.
TEST_F(ExternalRuns, AreChosenFromResults) {
  ASSERT_EQ(run(square(), {"--scheme", "grunwald_letnikov"}).code, 0);
  const auto answer = printed(fdebench({"choose", "power:p=2", "--error", "2e-3", "--results", results_}));
  EXPECT_THAT(answer, HasSubstr("run: mine with N = 8\ndelivers: error 1.0e-3 "));
  EXPECT_THAT(answer, HasSubstr(" of the wall clock\n"));
  const auto json = fdebench({"choose", "power:p=2", "--error", "2e-3", "--results", results_, "--json"});
  EXPECT_THAT(json.out, HasSubstr("\"wall_clock\":true"));
}

TEST_F(ExternalRuns, HaveNamesOfTheirOwn) {
  const auto refusal = [&](const std::string& external, const std::vector<std::string>& more = {}) {
    const auto answer = run(external, more);
    EXPECT_EQ(answer.code, 2) << external;
    EXPECT_EQ(std::ranges::count(answer.err, '\n'), 1) << answer.err;
    EXPECT_FALSE(std::filesystem::exists(results_));
    return answer.err;
  };
  EXPECT_THAT(refusal("l1=true"),
              HasSubstr("--external = l1: must be another name than those of our schemes"));
  EXPECT_THAT(refusal("=true"), HasSubstr("--external = : must be 1 to 100 bytes"));
  EXPECT_THAT(refusal("mine"), HasSubstr("--external = mine: must be NAME=COMMAND"));
  EXPECT_THAT(refusal("mine= "), HasSubstr("must be NAME=COMMAND"));
  EXPECT_THAT(refusal("a\nb=true"), HasSubstr("bytes of UTF-8 that print"));
  EXPECT_THAT(refusal("mine=true", {"--external", "mine=false"}),
              HasSubstr("a name that no other program has"));
  EXPECT_THAT(refusal("mine=true", {"--accuracy", "1e-3"}),
              HasSubstr("--accuracy = 0.001: must be without --external"));
}

}  // namespace
}  // namespace fde::bench
