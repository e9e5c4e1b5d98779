// SPDX-License-Identifier: MIT
// judge() needs no scheme: the measures of a run follow from its times, its values and the reference.

#include "fdebench/benchmarks/measures/judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/reference_data/data_table.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

std::optional<double> value(const Assessment& judgement, std::string_view id) {
  const auto found = std::ranges::find(judgement.measured, id, &MeasuredValue::id);
  return found == judgement.measured.end() ? std::nullopt : std::optional(found->value);
}

std::vector<std::string_view> ids(const Assessment& judgement) {
  std::vector<std::string_view> all;
  for (const auto& measured : judgement.measured) all.push_back(measured.id);
  return all;
}

// y(t) = t^2 is the solution of `power` for p = 2. The given values have errors of 0.01 and 0.02.
TEST(Judge, TakesWhatAnotherProgramWrote) {
  const auto table = parse_csv("written.csv", "t,y\n0,0\n0.5,0.26\n1,1\n2,3.98\n");
  std::vector<double> times;
  Rows columns(1, 4);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    times.push_back(std::stod(table.rows[row][0]));
    columns(0, static_cast<Eigen::Index>(row)) = std::stod(table.rows[row][1]);
  }
  const Scene scene = scene_of("power", {{"p", 2.0}});
  MemoizedReference reference(scene);
  const auto judged = judge_columns(times, columns, reference);
  EXPECT_EQ(judged.ending, RunOutcome{});
  EXPECT_EQ(judged.end_time, 2.0);
  EXPECT_NEAR(*value(judged, "error_end"), 0.02, 1e-15);
  EXPECT_NEAR(*value(judged, "error_maximum"), 0.02, 1e-15);
  EXPECT_NEAR(*value(judged, "mescd"), -std::log10(0.02 / 5.0), 1e-12);
  EXPECT_THAT(ids(judged), ElementsAre("error_end", "error_end_relative", "error_end_mixed", "error_end_peak",
                                       "error_maximum", "error_maximum_relative", "error_maximum_mixed",
                                       "error_maximum_peak", "error_relative", "mescd", "reference_bound",
                                       "reference_bound_maximum"));
}

// As for the solution of an integral equation, which is known less accurately near 0.
TEST(Judge, SaysHowWellTheReferenceIsKnownAtTheEndAndAtItsWorst) {
  const Trajectory path{.times = {0.0, 0.5, 1.0}, .y = Rows::Zero(2, 3)};
  const Rows reference = Rows::Ones(2, 3), bounds{{0.0, 1e-3, 1e-9}, {0.0, 1e-5, 1e-8}};
  const RunObservations observed;
  const FinishedRun run{path, path.y, reference, bounds, observed};
  EXPECT_EQ(measure::reference_bound.value(run), 1e-8);
  EXPECT_EQ(measure::reference_bound_maximum.value(run), 1e-3);
}

TEST(Judge, SaysFromWhenOnTheAccuracyIsLost) {
  const Scene scene = scene_of("power", {{"p", 2.0}});
  MemoizedReference reference(scene);
  const std::vector<double> times{0.0, 0.5, 1.0};
  const Rows columns{{0.0, 0.25, 3.0}};
  const auto judged = judge_columns(times, columns, reference);
  EXPECT_EQ(judged.ending, (RunOutcome{Verdict::accuracy_lost, "at t = 1"}));
  const Grid grid{.end = 1.0, .steps = 2};
  EXPECT_EQ(judge_columns(times, columns, reference, {.grid = grid}).ending.detail, "at step 2, t = 1");
}

TEST(Judge, OfASchemesTrajectoryCountsItsCost) {
  const Scene scene = scene_of("relaxation");
  MemoizedReference reference(scene);
  const auto path = solve("l1", scene.problem, 64);
  const auto judged = judge(scene, path, reference);
  EXPECT_EQ(value(judged, "states"), 1.0);
  EXPECT_GE(value(judged, "rhs_calls"), 64.0);
  EXPECT_EQ(value(judged, "rounding"), std::nullopt);
  EXPECT_EQ(value(judged, "expected_rate_end"), std::nullopt);
}

TEST(Judge, OfARunThatStoppedHasNoMeasures) {
  const Scene scene = scene_of("brusselator");
  MemoizedReference reference(scene);
  const auto judged = judge(scene, solve("adams_pc", scene.problem, 256), reference);
  EXPECT_EQ(judged.ending.kind, SolveStatus::non_finite);
  EXPECT_EQ(judged.ending.detail.find("at step 94, t = "), 0U);
  EXPECT_TRUE(judged.measured.empty());
}

TEST(Judge, ANumberThatIsNotFiniteIsNoMeasure) {
  const Scene scene = scene_of("relaxation");
  MemoizedReference reference(scene);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto judged = judge(scene, solve("l1", scene.problem, 8), reference, {.energy_residual = infinity});
  EXPECT_EQ(judged.ending, (RunOutcome{SolveStatus::non_finite, "in energy_residual"}));
  EXPECT_TRUE(judged.measured.empty());
}

// A column of a scene may have no value where the states have one: 0/0 of a formula.
TEST(Judge, AColumnThatIsNoNumberIsNeverAMeasure) {
  const Scene scene = scene_of("relaxation_pair");
  MemoizedReference reference(scene);
  const std::vector<double> times{0.0, 0.25 * scene.problem.end, 0.5 * scene.problem.end, scene.problem.end};
  for (Eigen::Index place = 0; place < 8; ++place) {
    Rows columns = reference.at(times);
    columns(place % 2, place / 2) = std::numeric_limits<double>::quiet_NaN();
    const auto judged = judge_columns(times, columns, reference);
    EXPECT_EQ(judged.ending.kind, SolveStatus::non_finite) << place;
    EXPECT_TRUE(judged.measured.empty()) << place;
  }
}

TEST(Endings, HaveNamesThatAreReadBack) {
  for (int i = 0; i <= static_cast<int>(SolveStatus::refused); ++i)
    EXPECT_EQ(outcome_named(name(static_cast<SolveStatus>(i))), static_cast<SolveStatus>(i));
  for (int i = 0; i <= static_cast<int>(Verdict::program_failed); ++i)
    EXPECT_EQ(outcome_named(name(static_cast<Verdict>(i))), static_cast<Verdict>(i));
  EXPECT_EQ(name(outcome_named("done")), "done") << "of another version";
  EXPECT_NE(outcome_named("done"), outcome_named("finished"));
}

TEST(Endings, AreSentences) {
  EXPECT_EQ(sentence({}), "finished");
  EXPECT_EQ(sentence({SolveStatus::non_finite, "at step 3, t = 0.5"}), "not finite at step 3, t = 0.5");
  EXPECT_EQ(sentence({SolveStatus::refused, "needs a uniform grid"}), "refused: needs a uniform grid");
  EXPECT_EQ(sentence({Verdict::overflow, "at t = 2"}), "the solution overflows at t = 2");
}

}  // namespace
}  // namespace fde::bench
