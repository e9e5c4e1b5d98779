// SPDX-License-Identifier: MIT
// Comparison of two sets of results, and merging of the files of several machines.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/reports/analysis/comparison.hpp"
#include "support/command_line_result.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// A run of l1 on `power` with its measures.
struct WrittenRun {
  int steps = 64;
  double error = 1e-3, relative = 1e-3, rounding = 1e-15;
  OutcomeKind ending = SolveStatus::finished;
  std::optional<double> least = 1.0, median = 1.1;
  std::optional<double> largest_error{}, bound{}, largest_bound{};
};

class Comparisons : public testing::Test {
 protected:
  [[nodiscard]] std::string write(const std::string& name, const std::vector<WrittenRun>& runs,
                                  const std::string& machine = "m") const {
    Session session{};
    session.machine = machine;
    std::string text = line_of(session);
    for (const auto& made : runs) text += text_of(made);
    folder_.write(name, text);
    return folder_.file(name);
  }

  [[nodiscard]] CommandOutput compare(const std::vector<WrittenRun>& before,
                                      const std::vector<WrittenRun>& now) const {
    return fdebench({"compare", write("before", before), write("now", now)});
  }

  static std::string text_of(const WrittenRun& made) {
    Record run{.key = {.scene = {"power"}, .scheme = "l1", .settings = {.resolution = made.steps}},
               .steps = made.steps,
               .end = 1.0,
               .ending = {made.ending, {}}};
    const auto set = [&](std::string_view quantity, std::optional<double> value) {
      if (value) run.values.set(quantity, *value);
    };
    if (is_compared(made.ending)) {
      set("error_end", made.error);
      set("error_relative", made.relative);
      set("rounding", made.rounding);
      set("error_maximum", made.largest_error);
      set("reference_bound", made.bound);
      set("reference_bound_maximum", made.largest_bound);
    }
    if (made.least) {
      run.timing.values.set("time_minimum", *made.least);
      run.timing.values.set("time_median", made.median.value_or(*made.least));
    }
    return line_of(run);
  }

  const TemporaryFolder folder_;
};

TEST_F(Comparisons, OfAFileWithItselfFindNothing) {
  const auto answer = compare({{}, {.steps = 128, .error = 5e-4}}, {{}, {.steps = 128, .error = 5e-4}});
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_EQ(answer.err, "");
  EXPECT_THAT(answer.out, HasSubstr("errors that moved: none\n"));
  EXPECT_THAT(answer.out, HasSubstr("2 runs in both, 0 only in the first, 0 only in the second\n"));
  EXPECT_THAT(answer.out, HasSubstr("times: 0 slower, 0 faster, 2 within the spread of their repeats\n"));
  EXPECT_THAT(answer.out,
              HasSubstr("time of 2 runs: 2.20 s -> 2.20 s, x 1 (0.909 to 1.1); geometric mean x 1\n"));
}

TEST_F(Comparisons, EndWithOneWhereAnErrorGrew) {
  const auto answer = compare({{.error = 1e-3}}, {{.error = 1.02e-3}});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.err, testing::MatchesRegex("fdebench: .*/now: an error grew or a verdict got worse\n"));
  EXPECT_THAT(answer.out,
              testing::ContainsRegex("grew +x 1.02 +1.0e-3 -> +1.0e-3 +error_end +power l1 N = 64\n"));
  EXPECT_EQ(compare({{.error = 1.02e-3}}, {{.error = 1e-3}}).code, 0);
  EXPECT_EQ(compare({{.error = 1e-3}}, {{.error = 1.009e-3}}).code, 0) << "within a hundredth";
}

// A slowdown by a factor of 10 exceeds the limit 2, but not the limit 10; a missing run has no time.
TEST_F(Comparisons, EndWithOneWhereMoreIsAskedOfTimesAndRuns) {
  const auto before = write("before", {{}, {.steps = 128}});
  const auto slow = write("slow", {{.least = 10.0, .median = 11.0}, {.steps = 128}}),
             half = write("half", {{}}), untimed = write("untimed", {{}, {.steps = 128, .least = {}}});
  EXPECT_EQ(fdebench({"compare", before, slow}).code, 0);
  EXPECT_EQ(fdebench({"compare", before, slow, "--max-slowdown", "2"}).err,
            "fdebench: " + slow + ": 1 times grew by more than 2\n");
  EXPECT_EQ(fdebench({"compare", before, slow, "--max-slowdown", "10"}).code, 0);
  EXPECT_EQ(fdebench({"compare", before, half}).code, 0);
  for (const auto& [file, missing] :
       {std::pair{half, "1 runs and 0 times"}, {untimed, "0 runs and 1 times"}}) {
    EXPECT_THAT(fdebench({"compare", before, file, "--require-all"}),
                fails_with(1, fmt::format("fdebench: {}: {} of the first are missing\n", file, missing)));
  }
  EXPECT_EQ(fdebench({"compare", before, before, "--require-all", "--max-slowdown", "1"}).code, 0);
  EXPECT_EQ(fdebench({"compare", before, before, "--max-slowdown", "0.5"}).code, 2);
}

// Errors of 1e-15 with rounding effects of 1e-15 count as grown from 5e-15 on.
TEST_F(Comparisons, TakeRoundingForNoChange) {
  const WrittenRun before{.error = 1e-15, .relative = 1e-12, .rounding = 1e-15};
  EXPECT_EQ(compare({before}, {{.error = 4.9e-15, .relative = 4.9e-12, .rounding = 1e-15}}).code, 0);
  EXPECT_EQ(compare({before}, {{.error = 5.1e-15, .relative = 1e-12, .rounding = 1e-15}}).code, 1);
  EXPECT_EQ(compare({before}, {{.error = 1e-15, .relative = 5.1e-12, .rounding = 1e-15}}).code, 1);
  EXPECT_EQ(compare({{.error = 0.0, .rounding = 0.0}}, {{.error = 1e-16, .rounding = 0.0}}).code, 1);
}

// The uncertainty of a maximum error includes the largest bound of the reference; older results have the
// bound at the end only.
TEST_F(Comparisons, TakeWhatTheReferenceLeavesOpenForNoChange) {
  const auto made = [](double error, double bound, std::optional<double> largest_bound) {
    return WrittenRun{
        .rounding = 0.0, .largest_error = error, .bound = bound, .largest_bound = largest_bound};
  };
  EXPECT_EQ(compare({made(1e-9, 1e-12, 1e-9)}, {made(1.9e-9, 1e-12, 1e-9)}).code, 0);
  EXPECT_EQ(compare({made(1e-9, 1e-12, 1e-9)}, {made(2.1e-9, 1e-12, 1e-9)}).code, 1);
  EXPECT_EQ(compare({made(1e-9, 1e-9, {})}, {made(1.9e-9, 1e-9, {})}).code, 0);
  EXPECT_EQ(compare({made(1e-9, 1e-12, {})}, {made(1.9e-9, 1e-12, {})}).code, 1);
}

TEST_F(Comparisons, EndWithOneWhereAVerdictGotWorse) {
  const WrittenRun inaccurate{.relative = 0.5}, lost{.relative = 0.5, .ending = Verdict::accuracy_lost},
      refused{.ending = SolveStatus::refused, .least = {}},
      diverged{.ending = SolveStatus::non_finite, .least = {}};
  const WrittenRun relative_same{};
  EXPECT_EQ(compare({relative_same}, {refused}).code, 1);
  EXPECT_EQ(compare({relative_same}, {diverged}).code, 1);
  EXPECT_EQ(compare({inaccurate}, {lost}).code, 1);
  EXPECT_EQ(compare({refused}, {diverged}).code, 1);
  EXPECT_EQ(compare({diverged}, {refused}).code, 0);
  EXPECT_EQ(compare({diverged}, {relative_same}).code, 0);
  EXPECT_THAT(compare({relative_same}, {diverged}).out,
              HasSubstr("worse    survives (finished) -> fails (not finite) :  power l1 N = 64\n"));
}

// Before 1.0 to 1.1 s, now 2.0 to 2.3 s: the ratio is between 2 / 1.1 and 2.3, by the medians 2.3 / 1.1.
TEST_F(Comparisons, TellARatioOfTimesWithItsNoise) {
  const auto slower = compare({{.least = 1.0, .median = 1.1}}, {{.least = 2.0, .median = 2.3}});
  EXPECT_EQ(slower.code, 0) << "a time is no error";
  EXPECT_THAT(slower.out,
              testing::ContainsRegex("slower +x 2.09 \\(1.82 to 2.3\\) +1.10 s -> +2.30 s +power l1"));
  const auto within = compare({{.least = 1.0, .median = 1.2}}, {{.least = 1.15, .median = 1.3}});
  EXPECT_THAT(within.out, HasSubstr("times: 0 slower, 0 faster, 1 within the spread of their repeats\n"));
  EXPECT_THAT(compare({{.least = 2.0, .median = 2.1}}, {{}}).out, HasSubstr("faster"));
}

TEST_F(Comparisons, PutTheWorstFirst) {
  std::vector<WrittenRun> before, now;
  for (int i = 1; i <= 30; ++i) {
    before.push_back({.steps = i});
    now.push_back({.steps = i, .error = 1e-3 * (1 + i)});
  }
  const auto out = compare(before, now).out;
  EXPECT_LT(out.find("N = 30\n"), out.find("N = 29\n"));
  EXPECT_THAT(out, HasSubstr("  ... and 10 more\n"));
  EXPECT_THAT(out, HasSubstr("errors: 30 grew, 0 fell\n"));
}

TEST_F(Comparisons, CountWhatOnlyOneHas) {
  EXPECT_THAT(printed(compare({{}, {.steps = 8}}, {{}, {.steps = 16}, {.steps = 32}})),
              HasSubstr("1 runs in both, 1 only in the first, 2 only in the second\n"));
  EXPECT_THAT(fdebench({"compare", write("a", {{.steps = 1}}), write("b", {{.steps = 2}})}),
              fails_with(2, HasSubstr("have no run in common\n")));
}

TEST_F(Comparisons, SayWhereTheMachinesDiffer) {
  const auto answer = fdebench({"compare", write("a", {{}}, "one"), write("b", {{}}, "other")});
  EXPECT_THAT(answer.out, HasSubstr("times are of different machines"));
}

// A session alone is no run.
TEST_F(Comparisons, PagesAndComparisonsNeedARun) {
  folder_.write("empty", "");
  const auto empty = folder_.file("empty"), session = write("session", {});
  for (const auto& file : {empty, session}) {
    const std::string line = "fdebench: " + file + ": holds no run\n";
    EXPECT_THAT(fdebench({"report", file, "--out", folder_.file("page")}), fails_with(2, line));
    EXPECT_EQ(fdebench({"compare", file, write("full", {{}})}).err, line);
    EXPECT_THAT(fdebench({"choose", "power", "--error", "1e-3", "--results", file}),
                fails_with(2, HasSubstr("no run")));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "page"));
}

TEST_F(Comparisons, AreOfMergedFilesToo) {
  const auto one = write("one", {{}}, "a"), other = write("other", {{.steps = 8}}, "b");
  const auto all = folder_.file("all");
  EXPECT_EQ(printed(fdebench({"merge", one, other, "--out", all})),
            all + "\n2 sessions, 2 rows, 0 repeated rows left out\n");
  EXPECT_THAT(fdebench({"compare", one, all}).out, HasSubstr("1 runs in both, 0 only in the first, 1 only"));
  EXPECT_EQ(fdebench({"merge", one, "--out", all}).err,
            "fdebench: " + all + ": exists, it must be a new file\n");
  EXPECT_EQ(fdebench({"merge", "--out", all + "2"}).code, 2);
  EXPECT_EQ(fdebench({"merge", one, "--out", "/nonexistent/all"}).code, 2);
}

// All runs without their times, sorted.
std::vector<std::string> untimed(const std::string& file) {
  std::vector<std::string> lines;
  for (Record& run : read_results(file).records) {
    run.timing = {};
    lines.push_back(line_of(run));
  }
  std::ranges::sort(lines);
  return lines;
}

TEST_F(Comparisons, ShardsTogetherAreTheWhole) {
  const std::string sweep =
      "run --scene power --scene relaxation --scene damped_oscillator --scene linear_system --steps 16,32 "
      "--repeat 1 --out " +
      folder_.path().string() + "/";
  std::vector<std::string> merge{"merge", "--out", folder_.path() / "all"};
  EXPECT_EQ(fdebench(sweep + "whole").code, 0);
  for (const std::string part : {"1", "2", "3"}) {
    EXPECT_EQ(fdebench(fmt::format("{}{} --shard {}/3", sweep, part, part)).code, 0);
    merge.push_back(folder_.path() / part);
  }
  EXPECT_EQ(fdebench(merge).code, 0);
  const auto together = untimed(folder_.path() / "all");
  EXPECT_GT(together.size(), 100U);
  EXPECT_EQ(together, untimed(folder_.path() / "whole"));
  for (const std::string shard : {"0/3", "4/3", "1", "1/0"})
    EXPECT_EQ(fdebench(fmt::format("{}none --shard {}", sweep, shard)).code, 2) << shard;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "none"));
}

TEST_F(Comparisons, DryRunsListTheRunsThatAreLeft) {
  const auto file = folder_.file("r");
  const std::string sweep = "run --scene power --scheme l1 --scheme adams_pc --repeat 1 --steps 16,32";
  const auto dry = fdebench(sweep + " --dry-run");
  EXPECT_EQ(dry.code, 0) << dry.err;
  EXPECT_EQ(std::ranges::count(dry.out, '\n'), 5);
  EXPECT_THAT(dry.out, HasSubstr("power adams_pc N = 16  "));
  EXPECT_THAT(dry.out, HasSubstr("\n4 runs, about 0 s\n"));
  EXPECT_EQ(fdebench(sweep + " --dry-run --out " + file).out.substr(0, 23), dry.out.substr(0, 23));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(fdebench(sweep + " --out " + file).code, 0);
  EXPECT_EQ(fdebench(sweep + ",64 --dry-run --out " + file).out.substr(0, 6), "power ");
  EXPECT_THAT(fdebench(sweep + ",64 --dry-run --out " + file).out, HasSubstr("\n2 runs, about 0 s\n"));
  EXPECT_EQ(fdebench(sweep).err, "fdebench: --out is required\n");
}

}  // namespace
}  // namespace fde::bench
