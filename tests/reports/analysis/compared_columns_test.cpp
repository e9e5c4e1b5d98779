// SPDX-License-Identifier: MIT
// Comparisons of runs that were judged over different columns.

#include "fdebench/reports/analysis/compared_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fdebench/reports/analysis/comparison.hpp"
#include "fdebench/reports/analysis/recorded_recommendation.hpp"
#include "reports/synthetic_results.hpp"

namespace fde::bench {
namespace {

constexpr ErrorKind kind{Norm::end, Scale::absolute};

// A run with its error in x and, if it has the column, in Dx.
void add(Results& results, const std::string& scheme, double seconds, const std::vector<double>& errors,
         bool is_recorded = true) {
  const bool is_part = errors.size() == 1;
  add_run(results, {"bagley_torvik", scheme, 64}, errors.back(), seconds);
  results.records.back().key.external = is_part;
  ColumnErrors& columns = results.records.back().columns;
  if (!is_recorded && !is_part) return;
  columns = {.names = is_part ? std::vector<std::string>{"x"} : std::vector<std::string>{"x", "Dx"},
             .is_part = is_part};
  columns.values.set("error_end", errors);
  columns.values.set("baseline_end", std::vector<double>(errors.size(), 1.0));
}

// Over x ours is within 1e-3 and quicker; over Dx, which the program does not print, it is not.
Results of_a_program_and_ours(bool is_recorded = true) {
  Results results = empty_results();
  add(results, "l1", 1e-3, {1e-4, 2e-2}, is_recorded);
  add(results, "numpy", 1.0, {5e-4});
  return results;
}

TEST(ComparedColumns, AreThoseThatAllRunsHave) {
  const Runs runs = runs_of(of_a_program_and_ours());
  EXPECT_EQ(compared_text(runs, {"bagley_torvik"}), "x");
  const auto made = recommend(runs, {"bagley_torvik"}, kind, 1e-3);
  ASSERT_EQ(made.options.size(), 2U);
  EXPECT_EQ(made.options[0].schemes.front(), "l1");
  EXPECT_EQ(made.options[0].error, 1e-4);
  EXPECT_THAT(to_text(made), testing::HasSubstr("at the end, absolute scale, in x; "));
}

TEST(ComparedColumns, AreAllWhereEveryRunHasThem) {
  Results results = empty_results();
  add(results, "l1", 1e-3, {1e-4, 2e-2});
  const Runs runs = runs_of(results);
  EXPECT_EQ(compared_text(runs, {"bagley_torvik"}), "");
  EXPECT_EQ(runs.finished.front()["error_end"], 2e-2);
}

// Without errors of single columns nothing can be compared with the program.
TEST(ComparedColumns, LeaveOutWhatHasOthers) {
  const Runs runs = runs_of(of_a_program_and_ours(false));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished.front().key.scheme, "l1");
  ASSERT_EQ(runs.failed.size(), 1U);
  EXPECT_EQ(not_compared_text(runs, {"bagley_torvik"}), "not compared: numpy, judged over x");
}

TEST(ComparedColumns, CanBeChosen) {
  Results results = empty_results();
  add(results, "l1", 1e-3, {1e-4, 2e-2});
  Runs runs = runs_of(results);
  compare_over(runs, {"bagley_torvik"}, {"x"});
  EXPECT_EQ(runs.finished.front()["error_end"], 1e-4);
  compare_over(runs, {"bagley_torvik"}, {"Dx"});
  EXPECT_EQ(runs.finished.front()["error_end"], 2e-2);
  compare_over(runs, {"bagley_torvik"}, {"y"});
  EXPECT_TRUE(runs.finished.empty());
}

// The error over x in one file and over both columns in the other: that it is larger says nothing.
TEST(ComparedColumns, OfTwoFilesAreNotCompared) {
  Results alone = empty_results();
  add(alone, "l1", 1e-3, {1e-4, 2e-2});
  const Runs before = runs_of(of_a_program_and_ours()), now = runs_of(alone);
  const auto comparison = compare(before, now);
  EXPECT_EQ(comparison.common, 1U);
  EXPECT_EQ(comparison.unlike, 1U);
  EXPECT_TRUE(comparison.errors.empty());
  EXPECT_EQ(compare(now, now).unlike, 0U);
}

// In SI units: the answer is at most 4.8e-3 m, the error allowed 1e-2.
TEST(SmallColumns, AreThoseWhoseValuesAreBelowTenTimesTheErrorAllowed) {
  const auto small = small_columns({}, 1e-2, {"x", "F"}, {4.8e-3, 200.0});
  ASSERT_EQ(small.size(), 1U);
  EXPECT_EQ(small[0].name, "x");
  EXPECT_DOUBLE_EQ(small[0].allowed, 1e-2 * 1.0048);
  EXPECT_TRUE(small_columns({.scale = Scale::peak}, 1e-2, {"x"}, {4.8e-3}).empty());
  EXPECT_TRUE(small_columns({.scale = Scale::absolute}, 4.7e-4, {"x"}, {4.8e-3}).empty());
  EXPECT_TRUE(small_columns({}, 1e-2, {"x"}, {0.0}).empty()) << "a column that is 0 has no size";
}

}  // namespace
}  // namespace fde::bench
