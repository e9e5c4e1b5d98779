// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/column_errors.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/judge.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// D^0.6 x is about two hundred times x: its error hides that of x.
struct TwoColumns {
  Trajectory path{.times = {0.0, 1.0, 2.0}, .y = Rows(2, 3)};
  Rows reference = (Rows(2, 3) << 0.0, 1.0, -0.5, 0.0, 200.0, 100.0).finished();
  Rows values = reference + (Rows(2, 3) << 0.0, 1e-3, 1e-4, 0.0, 0.2, 0.4).finished();
  Rows bounds = Rows::Zero(2, 3);
  RunObservations observed{};

  [[nodiscard]] ColumnErrors errors() const {
    return column_errors({path, values, reference, bounds, observed}, {"x", "Dx"}, false);
  }
  [[nodiscard]] double error_of_rows(const ErrorKind& kind, const std::vector<Eigen::Index>& rows) const {
    const Rows some = values(rows, Eigen::all), exact = reference(rows, Eigen::all);
    return errors_of(kind.norm, some, exact, divisors(kind.scale, path.times, exact)).maxCoeff();
  }
};

TEST(ColumnErrors, AreThoseOfAJudgementOfTheColumnAlone) {
  const TwoColumns run;
  const auto x = measures_of_columns(run.errors(), {"x"}),
             all = measures_of_columns(run.errors(), {"x", "Dx"});
  for (const ErrorKind& kind : error_kinds) {
    const std::string id(error_measure(kind));
    EXPECT_NEAR(*x.at(id) / run.error_of_rows(kind, {0}), 1.0, 1e-5) << id;
    EXPECT_NEAR(*all.at(id) / run.error_of_rows(kind, {0, 1}), 1.0, 1e-5) << id;
    EXPECT_FALSE(x.at(std::string(baseline_measure(kind)))) << "the run is better than y = 0";
  }
  EXPECT_NEAR(*x.at("error_maximum"), 1e-3, 1e-9);
  EXPECT_NEAR(*all.at("error_maximum"), 0.4, 1e-6);
}

TEST(ColumnErrors, OfOtherColumnsAreNotKnown) {
  const TwoColumns run;
  EXPECT_TRUE(measures_of_columns(run.errors(), {"x", "dx"}).empty());
  EXPECT_TRUE(measures_of_columns(ColumnErrors{.names = {"x"}}, {"x"}).empty());
}

// A run that is no better than y = 0 in one column is useless there, whatever the others are.
TEST(ColumnErrors, KeepTheBaselineOfTheirColumn) {
  TwoColumns run;
  run.values.row(0).setConstant(2.0);
  const auto x = measures_of_columns(run.errors(), {"x"}), other = measures_of_columns(run.errors(), {"Dx"});
  EXPECT_EQ(x.at("baseline_maximum"), 1.0);
  EXPECT_FALSE(other.at("baseline_maximum"));
}

TEST(ColumnErrors, AreRecordedOfEveryRunWithSeveralColumnsAndOfAPart) {
  const Scene one = scene_of("power", {{"p", 2.0}}), two = scene_of("relaxation_pair");
  const std::vector<double> times{0.0, one.problem.end};
  MemoizedReference of_one(one);
  const auto judged = judge_columns(times, of_one.at(times), of_one, {}, {one.outputs.names});
  EXPECT_EQ(judged.columns, ColumnErrors{});
  MemoizedReference x_only(two, {0});
  const std::vector<double> ends{0.0, two.problem.end};
  const auto part = judge_columns(ends, x_only.at(ends), x_only, {}, {{two.outputs.names[0]}, true});
  EXPECT_TRUE(part.columns.is_part);
  EXPECT_EQ(*part.columns.values.find("error_end"), std::vector{0.0});
}

}  // namespace
}  // namespace fde::bench
