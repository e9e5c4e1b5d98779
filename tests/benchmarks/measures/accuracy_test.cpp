// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/accuracy.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fdebench/benchmarks/measures/rounding.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// One column of ten times, 1 everywhere.
Rows ones() { return Rows::Ones(1, 10); }

TEST(Tolerance, IsLostFromWhereTheErrorStaysAboveTheValue) {
  Rows values = ones();
  values.rightCols(3).setConstant(2.5);
  EXPECT_EQ(accuracy_lost(values, ones()), 7);
  values(0, 9) = 1.5;  // accurate again
  EXPECT_EQ(accuracy_lost(values, ones()), std::nullopt);
}

TEST(Tolerance, IsLostWhereZeroWouldBeNoWorse) {
  EXPECT_EQ(accuracy_lost(Rows::Constant(1, 10, 1e-30), ones()), 0);
  EXPECT_EQ(accuracy_lost(Rows::Zero(1, 10), Rows::Zero(1, 10)), std::nullopt);
}

TEST(Tolerance, IsNotLostWhereTheValueOnlyPassesThroughZero) {
  Rows reference = Rows::Ones(1, 100), values = reference;
  reference(0, 99) = 0.0;
  values(0, 99) = 1e-3;
  EXPECT_EQ(accuracy_lost(values, reference), std::nullopt);
}

TEST(Tolerance, IsNotLostToRoundingOfLargerValues) {
  Rows reference = ones(), values = reference;
  reference.rightCols(5).setZero();
  values.rightCols(5).setConstant(1e-16);
  EXPECT_EQ(accuracy_lost(values, reference), std::nullopt);
}

TEST(Tolerance, IsLostWhereTheReferenceIsInfinite) {
  Rows reference = ones();
  reference.rightCols(5).setConstant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(accuracy_lost(ones(), reference), 5);
  EXPECT_EQ(first_not_finite(reference), 5);
  EXPECT_EQ(accuracy_lost(3.0 * ones(), reference), 0);
}

TEST(Tolerance, OfSeveralColumnsIsThatOfTheWorst) {
  Rows reference(2, 10), values(2, 10);
  reference << Rows::Ones(1, 10), 1e-6 * Rows::Ones(1, 10);
  values << Rows::Ones(1, 10), 1.5e-6 * Rows::Ones(1, 10);
  EXPECT_DOUBLE_EQ(*relative_error(values, reference, Vec::Zero(2)), 0.5);
  EXPECT_EQ(accuracy_lost(values, reference), std::nullopt);
}

TEST(Tolerance, RelativeToAThousandthOfTheSizeNearAZero) {
  Rows reference = Rows::Ones(1, 20), values = reference;
  reference(0, 19) = 1e-9;
  values(0, 19) = 1e-9 + 1e-4;
  EXPECT_NEAR(*relative_error(values, reference, Vec::Zero(1)), 0.1, 1e-12);
  EXPECT_NEAR(*relative_error(values, reference, Vec::Constant(1, 1e-3)), 1.1, 1e-12);
  EXPECT_EQ(relative_error(Rows::Zero(1, 20), Rows::Zero(1, 20), Vec::Zero(1)), std::nullopt);
}

// How much the values at the times of the coarse grid change when its steps are halved.
double change(const Trajectory& coarse, const Trajectory& fine) {
  double largest = 0.0;
  for (Eigen::Index n = 0; n < coarse.y.cols() && 2 * n < fine.y.cols(); ++n)
    largest = std::max(largest, (coarse.y.col(n) - fine.y.col(2 * n)).cwiseAbs().maxCoeff());
  return largest;
}

// Values in other units are the same values up to rounding, in every scene and scheme that fits. Where
// starting weights amplify rounding, as on the ten rows of distributed_relaxation, it stays far below the
// error. The steps are small: with 32 steps on relaxation_pair, bdf5 solves the first ten as one system and
// amplifies rounding 1e7 times.
class OtherUnits : public testing::TestWithParam<const SceneFactory*> {};

TEST_P(OtherUnits, ChangeNothingButRounding) {
  constexpr double unit = 0.7;
  constexpr int steps = 256;
  const Scene scene = make_scene(*GetParam());
  const Problem other = rescaled_problem(unit, scene.problem);
  for (const auto& scheme : schemes()) {
    const Grid grid{scene.problem.end, steps}, coarse{scene.problem.end, steps / 2};
    if (unsupported_reason(scheme, scene.problem, grid)) continue;
    const auto path = scheme.solve(scene.problem, grid, {}), again = scheme.solve(other, grid, {});
    EXPECT_EQ(path.status, again.status) << scheme.id;
    if (path.status != SolveStatus::finished || !(path.y.cwiseAbs().maxCoeff() < 1e6)) continue;  // blows up
    const double size = path.y.cwiseAbs().maxCoeff();
    const double difference = (path.y - unit * again.y).cwiseAbs().maxCoeff();
    if (difference < 1e-9 * size) continue;
    EXPECT_LT(difference, 1e-4 * change(scheme.solve(scene.problem, coarse, {}), path)) << scheme.id;
  }
}

std::vector<const SceneFactory*> makers() {
  std::vector<const SceneFactory*> all;
  for (const auto& factory : built_in_scenes()) all.push_back(&factory);
  return all;
}
INSTANTIATE_TEST_SUITE_P(, OtherUnits, testing::ValuesIn(makers()), id_of_param);

std::string ending(const ParameterValues& values, std::string_view scheme, int steps) {
  const Scene scene = make_scene(*find_scene("relaxation"), values);
  MemoizedReference reference(scene);
  return sentence(examine({}, scene, reference, *find_scheme(scheme), {steps}).ending);
}

// D^0.5 y = -1e6 y: after ten steps the result of a scheme may be farther from the reference than 0 is.
TEST(Examination, SaysWhereTheAccuracyIsLost) {
  EXPECT_EQ(ending({{"lambda", -1e6}}, "product_trapezoidal", 64), "accuracy lost at step 1, t = 0.015625");
  EXPECT_EQ(ending({{"lambda", -1e6}}, "grunwald_letnikov", 64), "finished");
}

// Backward Euler in differences of y: the rounding errors of all steps add up, to at most N units in the last
// place.
TEST(Examination, MeasuresWhatRoundingDoes) {
  const Scene scene = make_scene(*find_scene("power"), {{"gamma", 1.0}, {"p", 2.0}});
  MemoizedReference reference(scene);
  const auto rounding = [&](int steps) {
    return *examine({}, scene, reference, *find_scheme("l1"), {steps})["rounding"];
  };
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  EXPECT_LE(rounding(64), 64 * epsilon);
  EXPECT_LE(rounding(1 << 16), (1 << 16) * epsilon);
  EXPECT_GT(rounding(1 << 16), rounding(64) + epsilon);
}

}  // namespace
}  // namespace fde::bench
