// SPDX-License-Identifier: MIT
// Trajectories of external programs. The solution of `power` for p = 2 is y(t) = t^2, up to t = 1.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "support/command_line_result.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class Judging : public testing::Test {
 protected:
  [[nodiscard]] CommandOutput judge(const std::string& csv, std::vector<std::string> more = {},
                                    const std::string& scene = "power:p=2") const {
    folder_.write("path.csv", csv);
    std::vector<std::string> words{"judge", scene, file_};
    words.insert(words.end(), more.begin(), more.end());
    return fdebench(words);
  }

  // The message for a refused file, after the name of the file.
  [[nodiscard]] std::string refusal(const std::string& csv, const std::string& scene = "power:p=2") const {
    const auto answer = judge(csv, {}, scene);
    EXPECT_EQ(answer.code, 2) << csv;
    EXPECT_EQ(answer.out, "");
    const std::string begin = "fdebench: " + file_;
    EXPECT_EQ(answer.err.substr(0, begin.size()), begin);
    return answer.err.substr(std::min(begin.size(), answer.err.size()));
  }

  // The number printed after a name.
  static double number(const CommandOutput& answer, const std::string& name) {
    const auto at = ("\n" + answer.out).find("\n" + name + " ");
    EXPECT_NE(at, std::string::npos) << answer.out << answer.err;
    return at == std::string::npos ? std::nan("") : std::stod(answer.out.substr(at + name.size()));
  }

  const TemporaryFolder folder_;
  const std::string file_ = folder_.file("path.csv");
  const std::string results_ = folder_.file("results.jsonl");
};

// Times that form no grid; errors of 0.01, and at the end 0.02, where |error| / (1 + |y|) is 0.01.
TEST_F(Judging, TakesAnyTimes) {
  const auto answer = judge("t,y\n0,0\n0.1,0.02\n0.77,0.5929\n1,1.02\n");
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("scene power:p=2\nrows 4\n"));
  EXPECT_THAT(answer.out, HasSubstr("\nending finished\n"));
  EXPECT_NEAR(number(answer, "error_end"), 0.02, 1e-15);
  EXPECT_NEAR(number(answer, "error_maximum"), 0.02, 1e-15);
  EXPECT_NEAR(number(answer, "mescd"), 2.0, 1e-13);
  EXPECT_THAT(answer.out, HasSubstr(" digits\n"));
  EXPECT_THAT(answer.out, Not(HasSubstr("time_")));
}

TEST_F(Judging, TakesTheFilesThatOtherProgramsWrite) {
  const auto plain = judge("t,y\n0,0\n1,1.5\n").out;
  for (const auto* csv : {"# t,y\n0,0\n1,1.5\n", "\xEF\xBB\xBFt,y\r\n0,0\r\n1,1.5\r\n",
                          "\"t\",\"y\"\n0,0\n1,1.5", " t , y \n 0.0e+00 , 0 \n+1 ,\t1.5 \n\n\n"}) {
    EXPECT_EQ(judge(csv).out, plain) << csv;
  }
}

// Errors of 1, 2 and 0 standard deviations: chi^2 is 5 with as many degrees as there are rows.
TEST_F(Judging, ComparesWithStandardDeviations) {
  const auto answer = judge("t,sd_y,y\n0.5,0.1,0.35\n0.8,0.01,0.66\n1,1,1\n");
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_NEAR(number(answer, "chi_squared"), 5.0, 1e-5);
  EXPECT_EQ(number(answer, "degrees_of_freedom"), 3.0);
  EXPECT_NEAR(number(answer, "probability"), 0.1718, 5e-4);  // three digits
  EXPECT_THAT(judge("t,y\n0,0\n1,1.5\n").out, Not(HasSubstr("chi_squared")));
  EXPECT_EQ(refusal("t,y,sd_y\n0,0,1\n1,1,0\n"), ": line 3: sd_y = 0: must be a finite number above 0\n");
  EXPECT_EQ(refusal("t,sd_y\n0,1\n"), ": line 1: has no column of the scene; they are y\n");
  EXPECT_EQ(refusal("t,phi,dphi,sd_phi\n0,1,0,1\n", "pendulum"),
            ": line 1: column sd_dphi is missing: all columns have standard deviations or none\n");
}

// D(x,0.5) of duffing.toml is Dx_0.5, in what solve and exact print and in what judge takes.
TEST_F(Judging, TakesPlainNames) {
  const std::string duffing = FDE_SOURCE_DIR "/docs/examples/duffing.toml";
  for (const std::string command : {"solve", "exact"}) {
    const auto printed = command == "solve" ? fdebench({command, duffing, "--scheme", "bdf2", "--steps",
                                                        "512", "--points", "3", "--plain-names"})
                                            : fdebench({command, duffing, "--at", "10,20", "--plain-names"});
    EXPECT_THAT(printed.out, testing::StartsWith("t,x,Dx_0.5,Dx_1")) << printed.err;
    if (command == "solve") {
      EXPECT_EQ(judge(printed.out, {}, duffing).code, 0);
      EXPECT_EQ(refusal("t,x,Dx_0.5,\"D(x,0.5)\"\n0,0,0,0\n", duffing),
                ": line 1: column D(x,0.5) occurs twice\n");
    }
  }
}

// A message that contained the NUL would end there.
TEST_F(Judging, NamesANul) {
  const std::string csv{"t,y\n0,0\n1,\0", 11};
  EXPECT_EQ(refusal(csv + "5\n"), ": line 3: has a NUL byte, which no CSV has\n");
}

// So few bytes fit in the buffer of the pipe: the write does not block before the read.
TEST_F(Judging, ReadsFromAPipe) {
  const std::string csv = "# t,y\n0,0\n1,1.5\n";
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  ASSERT_EQ(write(ends[1], csv.data(), csv.size()), std::ssize(csv));
  close(ends[1]);
  const auto answer = fdebench({"judge", "power:p=2", fmt::format("/dev/fd/{}", ends[0])});
  close(ends[0]);
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_EQ(answer.out, judge(csv).out);
}

// The time in the first line of the file is used unless --seconds is given.
TEST_F(Judging, TakesTheTimeThatAFileSays) {
  const std::string csv = "# seconds: 0.125\nt,y\n0,0\n1,1.5\n";
  EXPECT_EQ(number(judge(csv), "time_minimum"), 0.125);
  EXPECT_EQ(number(judge(csv, {"--seconds", "0.5"}), "time_minimum"), 0.5);
  EXPECT_THAT(refusal("# seconds: 0\nt,y\n0,0\n1,1.5\n"), HasSubstr(": line 1: seconds = 0: must be"));
  EXPECT_THAT(refusal("# seconds: 1\n"), HasSubstr(": line 2: there is no header"));
}

// The output of solve has the same errors as the run in a sweep; the column `energy` is ignored.
TEST_F(Judging, SaysOfOurOwnRunWhatRunSays) {
  const auto solved = fdebench("solve damped_oscillator --scheme l1 --steps 64").out;
  const auto judged = judge(solved, {}, "damped_oscillator");
  EXPECT_EQ(judged.code, 0) << judged.err;
  EXPECT_EQ(
      fdebench("run --scene damped_oscillator --scheme l1 --steps 64 --repeat 1 --out " + results_).code, 0);
  const Record run = read_results(results_).records.front();
  for (const auto& [quantity, value] : run.values) {
    if (!quantity.starts_with("error_")) continue;
    EXPECT_EQ(number(judged, std::string(quantity)), value) << quantity;
  }
}

TEST_F(Judging, DescribesItsSceneOnceForThePage) {
  for (const std::string name : {"one", "other"})
    EXPECT_EQ(judge("t,y\n0,1\n0.5,0.52\n", {"--name", name, "--out", results_}).code, 0);
  const auto results = read_results(results_);
  EXPECT_EQ(results.records.back().key.scheme, "other");
  ASSERT_EQ(results.scenes.size(), 1U);
  EXPECT_EQ(results.scenes[0].scene, results.records.back().key.scene);
  EXPECT_EQ(results.scenes[0].solution->t.back(), 0.5) << "the end of the trajectory";
}

TEST_F(Judging, IsOfTheColumnsThatAreThere) {
  const auto solved = fdebench("solve damped_oscillator --scheme l1 --steps 4096 --every 256").out;
  std::istringstream lines(solved);
  std::string csv, line;
  while (std::getline(lines, line)) csv += line.substr(0, line.find(',', line.find(',') + 1)) + "\n";
  const auto all = judge(solved, {}, "damped_oscillator"), one = judge(csv, {}, "damped_oscillator");
  EXPECT_EQ(one.code, 0) << one.err;
  const auto name = csv.substr(2, csv.find('\n') - 2);
  EXPECT_THAT(one.out, HasSubstr("ending finished in " + name + "\n"));
  EXPECT_LE(number(one, "error_end"), number(all, "error_end"));
}

// Many rows are compared at the same times as a run of as many steps; the last row always is.
TEST_F(Judging, ComparesManyRowsAtSomeTimes) {
  constexpr int rows = 50'000;
  std::string csv = "t,y\n";
  for (int i = 0; i <= rows; ++i) {
    const double t = static_cast<double>(i) / rows;
    csv += fmt::format("{},{}\n", t, t * t + (i == rows ? 0.25 : 0.0));
  }
  const auto answer = judge(csv);
  EXPECT_THAT(answer.out, HasSubstr("rows 50001\n"));
  EXPECT_NEAR(number(answer, "error_end"), 0.25, 1e-15);
}

// A trajectory that ends early is compared with the scene up to its last time.
TEST_F(Judging, NamesTheEndOfAShorterTrajectory) {
  const auto answer = judge("t,y\n0.25,0.0625\n0.5,0.26\n", {"--out", results_});
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("scene power:p=2,until=0.5\n"));
  EXPECT_NEAR(number(answer, "error_end"), 0.01, 1e-15);
  EXPECT_EQ(read_results(results_).records.front().key.scene.until, 0.5);
}

TEST_F(Judging, EndsWhereAValueIsNotFinite) {
  for (const auto* value : {"nan", "NaN", "inf", "-Inf"}) {
    EXPECT_EQ(
        printed(judge(fmt::format("t,y\n0,0\n0.5,{}\n1,1\n", value), {"--seconds", "1", "--out", results_})),
        "scene power:p=2\nrows 3\nending not finite at t = 0.5\n");
  }
  const auto run = read_results(results_).records.back();
  EXPECT_EQ(run.ending.kind, SolveStatus::non_finite);
  EXPECT_EQ(run.ended_at, 0.5);
}

TEST_F(Judging, AddsToResultsUnderItsName) {
  EXPECT_EQ(fdebench("run --scene power:p=2 --scheme l1 --steps 16 --repeat 1 --out " + results_).code, 0);
  EXPECT_THAT(printed(judge("t,y\n0,0\n1,1.001\n",
                            {"--name", "my solver", "--seconds", "0.5,0.25,0.75", "--out", results_})),
              HasSubstr("\ntime_minimum 0.25 s\ntime_median 0.5 s\n"));
  const auto run = read_results(results_).records.back();
  EXPECT_TRUE(run.key.external);
  EXPECT_EQ(run.key.scheme, "my solver");
  EXPECT_EQ(run.steps, 2);
  const auto chosen = fdebench({"choose", "power:p=2", "--error", "0.1", "--results", results_});
  EXPECT_THAT(chosen.out, testing::ContainsRegex("\nmy solver +2 "));
  EXPECT_THAT(chosen.out, testing::ContainsRegex("\nl1 +16 "));
}

// The bounds that `exact` prints beside its values are ignored, with both kinds of names.
TEST_F(Judging, TakesWhatExactPrints) {
  for (const std::string more : {"", " --bounds", " --bounds --plain-names"}) {
    const auto table = printed(fdebench("exact pendulum --at 0,0.5,1" + more));
    EXPECT_LT(number(judge(table, {}, "pendulum:until=1"), "error_end"), 1e-15) << more;
  }
}

TEST_F(Judging, RefusesNamesThatWouldMislead) {
  for (const std::string name :
       {"l1", "a\nb", "\x1b[2J", "\xff", "\xc3", "\xed\xa0\x80", "\xc2\x85", "\x7f"}) {
    EXPECT_THAT(judge("t,y\n0,0\n1,1\n", {"--name", name}), fails_with(2, HasSubstr("--name = "))) << name;
  }
  EXPECT_EQ(judge("t,y\n0,0\n1,1\n", {"--name", "Größe Δt"}).code, 0);
  EXPECT_EQ(judge("t,y\n0,0\n1,1\n", {"--name", std::string(101, 'x')}).code, 2);
}

TEST_F(Judging, RefusesBadFilesWithTheirLine) {
  EXPECT_EQ(refusal(""), ": line 1: there is no header\n");
  EXPECT_EQ(
      refusal("\n"),
      ": line 1: '': must be the header, t and one or more of the columns y, with commas between them\n");
  EXPECT_EQ(refusal("time,y\n0,0\n"),
            ": line 1: 'time,y': must be the header, t and one or more of the columns y, with commas between "
            "them\n");
  EXPECT_THAT(refusal("0,1\n1,0\n", "pendulum"),
              HasSubstr("the columns phi,Dbeta_phi,dphi,Dalpha_phi, with"));
  EXPECT_EQ(refusal("t\n0\n"), ": line 1: has no column of the scene; they are y\n");
  EXPECT_EQ(refusal("t,z\n0,0\n"), ": line 1: column z: no such column; there are y\n");
  EXPECT_EQ(refusal("t,y,y\n0,0,0\n"), ": line 1: column y occurs twice\n");
  EXPECT_EQ(refusal("t,y\n"), ": line 2: there is no row behind t = 0\n");
  EXPECT_EQ(refusal("t,y\n0,0\n"), ": line 3: there is no row behind t = 0\n");
  EXPECT_EQ(refusal("t,y\n0,0\n1\n"), ": line 3: must have 2 cells, as the header, not 1\n");
  EXPECT_EQ(refusal("t,y\n0,0\n1,1,1\n"), ": line 3: must have 2 cells, as the header, not 3\n");
  EXPECT_EQ(refusal("t,y\n0,0\n1,one\n"), ": line 3: y = one: must be a number\n");
  EXPECT_EQ(refusal("t,y\n0,0\n1,\n"), ": line 3: y = : must be a number\n");
  EXPECT_EQ(refusal("t,y\n0,0\nnan,1\n"), ": line 3: t = nan: must be a finite number of at least 0\n");
  EXPECT_EQ(refusal("t,y\n-0.5,0\n"), ": line 2: t = -0.5: must be a finite number of at least 0\n");
  EXPECT_EQ(refusal("t,y\n0,0\n1.1,0\n"), ": line 3: t = 1.1: must be in [0, 1], as in the scene\n");
  EXPECT_EQ(refusal("t,y\n0,0\n0.5,0\n0.5,0\n"), ": line 4: t = 0.5: must be above 0.5, the time before\n");
  EXPECT_EQ(refusal("t,y\n0,0\n\n1,1\n"), ": line 4: a row behind an empty line\n");
  EXPECT_EQ(refusal("t,y\n0,0\n1," + std::string(2'000'000, '1') + "\n"),
            ": line 3 is longer than 1048576 bytes\n");
  EXPECT_EQ(fdebench({"judge", "power", folder_.path().string()}).err,
            "fdebench: " + folder_.path().string() + ": cannot be read: is not a file\n");
  EXPECT_EQ(fdebench({"judge", "power", "/nonexistent.csv"}).err,
            "fdebench: /nonexistent.csv: cannot be read: No such file or directory\n");
}

TEST_F(Judging, OfAScenePosedAtBothEndsIsOfItsWholeTime) {
  EXPECT_THAT(refusal("t,q1\n0,0\n0.5,0\n", "fractional_hamilton"),
              HasSubstr("scene fractional_hamilton is posed at both ends"));
}

}  // namespace
}  // namespace fde::bench
