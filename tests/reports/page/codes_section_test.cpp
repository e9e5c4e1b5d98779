// SPDX-License-Identifier: MIT
// The section "Beside other codes" of synthetic results.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "reports/synthetic_results.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// A run of another program, with this error at the end.
void add_other(Results& results, const std::string& name, int steps, double error, double seconds,
               const ProgramFacts& program, const RunOutcome& ending = {}) {
  const SyntheticRun run{"pendulum", name, steps};
  if (ending.kind == OutcomeKind{SolveStatus::finished}) {
    add_value(results, run, "error_end", error);
    add_value(results, run, "time_minimum", seconds);
    add_value(results, run, "time_median", seconds);
    add_value(results, run, "time_setup", seconds / 2);
  }
  add_ending(results, run, end_time, ending);
  results.records.back().key.external = true;
  results.records.back().program = program;
}

// l1 has the errors 1e-3 and 1e-5, in 1 and 4 s.
Results results_of_codes() {
  auto results = empty_results();
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  add_run(results, {"pendulum", "l1", 128}, 1e-5, 4.0);
  const ProgramFacts octave{"flmm2", "1.0", "GNU Octave 7.3.0"};
  add_other(results, "flmm2 method 1", 64, 5e-3, 3.0, octave);
  add_other(results, "flmm2 method 2", 64, 2e-3, 2.0, octave);
  add_other(results, "flmm2 method 1", 128, 1e-6, 20.0, octave);
  add_other(results, "tsfcoll", 64, 0.0, 0.0, {"tsfcoll", "2023", "GNU Octave 7.3.0"},
            {SolveStatus::refused, "takes scalar equations"});
  return results;
}

json rows_in(const json& codes) { return codes["groups"]["error_end"].front()["rows"]; }

TEST(CodesSection, HasARowForEachCodeOursFirst) {
  const auto codes_section = section(page_data(read_runs(results_of_codes())), "codes");
  std::vector<std::string> codes;
  for (const auto& row : rows_in(codes_section)) codes.push_back(row["code"]);
  EXPECT_EQ(codes, (std::vector<std::string>{"fdebench", "flmm2", "tsfcoll"}));
  EXPECT_EQ(codes_section["octave"], true);
}

// To 1e-2 the second setting is the quickest, and twice as slow as l1; to 1e-4 and 1e-6 the first, and no
// run of l1 reaches 1e-6.
TEST(CodesSection, TakesTheQuickestSettingWithinEachError) {
  const auto row = rows_in(section(page_data(read_runs(results_of_codes())), "codes"))[1];
  EXPECT_EQ(row["language"], "GNU Octave 7.3.0");
  const auto& cells = row["cells"];
  EXPECT_EQ(cells[0]["line"], "flmm2 method 2");
  EXPECT_DOUBLE_EQ(cells[0]["seconds"], 2.0);
  EXPECT_DOUBLE_EQ(cells[0]["first_seconds"], 3.0);
  EXPECT_DOUBLE_EQ(cells[0]["ratio"], 2.0);
  EXPECT_EQ(cells[1]["line"], "flmm2 method 1");
  EXPECT_DOUBLE_EQ(cells[1]["ratio"], 5.0);
  EXPECT_DOUBLE_EQ(cells[2]["seconds"], 20.0);
  EXPECT_FALSE(cells[2].contains("ratio"));
  EXPECT_DOUBLE_EQ(cells[3]["best"]["error"], 1e-6);
}

TEST(CodesSection, SaysWhyACodeSolvesNothing) {
  const auto row = rows_in(section(page_data(read_runs(results_of_codes())), "codes"))[2];
  EXPECT_EQ(row["ending"], "refused");
  EXPECT_EQ(row["detail"], "takes scalar equations");
}

TEST(CodesSection, IsAbsentWithoutOtherPrograms) {
  auto results = empty_results();
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  EXPECT_TRUE(section(page_data(read_runs(results)), "codes").is_null());
}

}  // namespace
}  // namespace fde::bench
