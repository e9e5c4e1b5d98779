// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/direct_history.hpp"
#include "fdebench/schemes/history/exponential_history.hpp"
#include "fdebench/schemes/history/variable_step_history.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {
namespace {

// Half a unit in the last place of a double, relative to it.
constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

// Families with orders below, at and above 1.
const WeightTables every_family{
    {{&families::rectangle, 0.3}, {&families::rectangle, 1.0}, {&families::rectangle, 1.7}},
    {{&families::trapezoid, 0.3}, {&families::trapezoid, 1.0}, {&families::trapezoid, 1.7}},
    {{&families::grunwald_letnikov, 0.3}, {&families::grunwald_letnikov, 1.0}, {&families::l1, 0.4}},
    {{&families::l1, 0.3}, {&families::l1, 1.0}, {&families::trapezoid, 0.01}},
    {{&families::bdf2, 0.3}, {&families::bdf2, 1.0}, {&families::bdf2, 1.7}},
    {{&families::bdf6, 0.3}, {&families::bdf5, 1.0}, {&families::bdf6, 1.7}},
    {{&families::newton_gregory_2, 0.3}, {&families::newton_gregory_3, 1.0}, {&families::bdf4, 2.0}},
    {{&families::fractional_trapezoidal, 0.3},
     {&families::fractional_trapezoidal, 1.0},
     {&families::fractional_trapezoidal, 1.7}},
    {{&families::l2_1_sigma, 0.3}, {&families::l2_1_sigma, 1.0}, {&families::l2_1_sigma, 0.9}}};

// The families that support variable steps.
const WeightTables interpolating_families{
    {{&families::rectangle, 0.3}, {&families::rectangle, 1.0}, {&families::rectangle, 1.7}},
    {{&families::trapezoid, 0.3}, {&families::trapezoid, 1.0}, {&families::trapezoid, 1.7}},
    {{&families::l1, 0.3}, {&families::l1, 1.0}, {&families::trapezoid, 2.0}}};

// w(1), w(2), ...
Vec weights_of(const WeightTable& table, Eigen::Index count) {
  return Vec::NullaryExpr(count, [&](Eigen::Index k) { return weight(table, k + 1); });
}

// The sum at step n by its definition, term by term in extended precision, and the sum of the absolute terms.
struct Defined {
  double value, size;
};
Defined by_definition(const WeightTable& table, const Vec& weights, const Rows& samples,
                      Eigen::Index component, Eigen::Index n) {
  const long double first = first_sample_weight(table, n).value_or(weight(table, n)) *
                            static_cast<long double>(samples(component, 0));
  long double sum = first, size = std::abs(first);
  for (Eigen::Index j = 1; j < n; ++j) {
    const long double term = static_cast<long double>(weights[n - j - 1]) * samples(component, j);
    sum += term;
    size += std::abs(term);
  }
  return {static_cast<double>(sum), static_cast<double>(size)};
}

Rows random_samples(Eigen::Index components, Eigen::Index count, double lowest = 0.5) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(lowest, 1.5);
  return Rows::NullaryExpr(components, count, [&] { return uniform(generator); });
}

StepPlan equal_steps(int count) { return step_plan({.end = 1.0, .steps = count}); }

// Times for equal steps, which histories ignore.
double step_number(Eigen::Index n) { return static_cast<double>(n); }

auto times_of(const Grid& grid) {
  return [grid](Eigen::Index n) { return grid.time(static_cast<int>(n)); };
}

// The memory sums of these samples at time(0), time(1), ...: one column a step, the components of all sums
// stacked.
template <typename Time>
Matrix convolutions(History& history, std::size_t sums, const Rows& samples, Time time) {
  const auto components = samples.rows();
  Matrix results(static_cast<Eigen::Index>(sums) * components, samples.cols());
  for (Eigen::Index n = 0; n < samples.cols(); ++n) {
    history.push(time(n), samples.col(n));
    for (std::size_t sum = 0; sum < sums; ++sum) {
      history.convolve(time(n + 1), sum,
                       results.col(n).segment(static_cast<Eigen::Index>(sum) * components, components));
    }
  }
  return results;
}

// Expects |a - b| <= tolerance * size in every entry; stops at the first failure.
void expect_near(const Matrix& a, const Matrix& b, const Matrix& size, double tolerance) {
  for (Eigen::Index n = 1; n <= a.cols(); ++n) {
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
      ASSERT_NEAR(a(row, n - 1), b(row, n - 1), tolerance * size(row, n - 1)) << "row " << row << ", n " << n;
    }
  }
}

class Histories : public testing::TestWithParam<HistoryKind> {
 protected:
  // Expects, from first_step on, an error of at most 1e-14 times the sum of the absolute terms. These are 90
  // units: nine for the tolerance of the exponentials, the others for the rounding of long sums, most of
  // which cancels.
  static void expect_as_defined(const Rows& samples, Eigen::Index first_step) {
    const auto steps = samples.cols();
    const auto history = make_history(GetParam(), every_family, equal_steps(static_cast<int>(steps)), 1e-15);
    const Matrix results = convolutions(*history, every_family.size(), samples, step_number);
    for (Eigen::Index row = 0; row < results.rows(); ++row) {
      const auto component = row % samples.rows();
      const auto& table =
          every_family[static_cast<std::size_t>(row / samples.rows())][static_cast<std::size_t>(component)];
      const Vec weights = weights_of(table, steps);
      for (Eigen::Index n = first_step; n <= steps; ++n) {
        const auto [value, size] = by_definition(table, weights, samples, component, n);
        EXPECT_NEAR(results(row, n - 1), value, 1e-14 * size) << "row " << row << ", n " << n;
      }
    }
  }
};

TEST_P(Histories, ConvolveAsDefinedAtEveryStep) { expect_as_defined(random_samples(3, 300), 1); }

TEST_P(Histories, ConvolveAsDefinedAfterManySteps) { expect_as_defined(random_samples(3, 5000), 4901); }

TEST_P(Histories, ConvolveSamplesOfChangingSignAsDefined) {
  expect_as_defined(random_samples(3, 5000, -1.5), 4901);
}

TEST_P(Histories, OrderOneNeedsNoMemoryForItsPast) {
  const WeightTables order_one{{{&families::trapezoid, 1.0}}}, order_half{{{&families::trapezoid, 0.5}}};
  EXPECT_LT(make_history(GetParam(), order_one, equal_steps(1000), 1e-15)->bytes(), 100U);
  EXPECT_GT(make_history(GetParam(), order_half, equal_steps(1000), 1e-15)->bytes(), 1000U);
}

TEST_P(Histories, EqualOrdersShareTheirWeights) {
  const WeightTable half{&families::trapezoid, 0.5}, third{&families::trapezoid, 0.3};
  EXPECT_LT(make_history(GetParam(), {{half, half}}, equal_steps(1000), 1e-15)->bytes(),
            make_history(GetParam(), {{half, third}}, equal_steps(1000), 1e-15)->bytes());
}

INSTANTIATE_TEST_SUITE_P(, Histories,
                         testing::Values(HistoryKind::automatic, HistoryKind::direct,
                                         HistoryKind::exponentials),
                         [](const auto& test) { return std::string(name(test.param)); });

class HistoriesOnVectorTargets : public testing::TestWithParam<std::string_view> {
 protected:
  void TearDown() override { select_vector_target(vector_targets().front()); }
};

// Without fused multiply-add each term has one more rounding.
TEST_P(HistoriesOnVectorTargets, DifferByRoundingOnly) {
  const Rows samples = random_samples(3, 1000);
  const auto on = [&](HistoryKind kind, std::string_view target) {
    select_vector_target(target);
    return convolutions(*make_history(kind, every_family, equal_steps(1000), 1e-15), every_family.size(),
                        samples, step_number);
  };
  for (const auto kind : {HistoryKind::direct, HistoryKind::exponentials}) {
    const Matrix here = on(kind, GetParam()), widest = on(kind, vector_targets().front());
    expect_near(here, widest, widest, 1e-14);
    if (GetParam().starts_with("AVX")) {
      EXPECT_EQ(here, widest) << name(kind);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, HistoriesOnVectorTargets, testing::ValuesIn(vector_targets()),
                         [](const auto& test) { return std::string(test.param); });

TEST(ExponentialHistory, NeedsMemoryForTheLogarithmOfTheStepsOnly) {
  const auto bytes = [](int steps) { return ExponentialHistory(every_family, steps, 1e-15).bytes(); };
  EXPECT_LT(bytes(100'000'000), 2 * bytes(10'000));
  EXPECT_LT(bytes(100'000'000), 100'000U * every_family.size() * every_family.front().size());
}

// The samples are positive, so the relative tolerance of the weights holds for the sum.
TEST(ExponentialHistory, IsSmallerForALooserToleranceAndWithinIt) {
  constexpr int steps = 2000;
  const Rows samples = random_samples(3, steps);
  DirectHistory direct(every_family, steps);
  ExponentialHistory fine(every_family, steps, 1e-15), coarse(every_family, steps, 1e-6);
  const Matrix exact = convolutions(direct, every_family.size(), samples, step_number);
  expect_near(convolutions(coarse, every_family.size(), samples, step_number), exact, exact, 1e-6);
  EXPECT_LT(coarse.bytes(), fine.bytes());
}

// A plain sum has one rounding a step. Two interval weights accurate to 8 ulp, the tolerance of the
// exponentials and a few products add 48 units.
constexpr double rounding_of_plain_sums(int steps) { return (steps + 48) * unit; }

// On a uniform grid whose times are all exact.
TEST(VariableStepHistories, GiveTheSumsOfTheOthersOnAUniformGrid) {
  constexpr Grid grid{.end = 50.0, .steps = 200};
  const Rows samples = random_samples(3, grid.steps);
  DirectHistory direct(interpolating_families, grid.steps);
  VariableStepDirectHistory variable(interpolating_families, step_plan(grid));
  VariableStepExponentialHistory exponentials(interpolating_families, step_plan(grid), 1e-15);
  const auto sums = interpolating_families.size();
  const Matrix expected = convolutions(direct, sums, samples, times_of(grid));
  constexpr double tolerance = rounding_of_plain_sums(grid.steps);
  expect_near(convolutions(variable, sums, samples, times_of(grid)), expected, expected, tolerance);
  expect_near(convolutions(exponentials, sums, samples, times_of(grid)), expected, expected, tolerance);
}

class HistoriesOnGradedGrids : public testing::TestWithParam<double> {
 protected:
  static constexpr int steps = 200;
  static Matrix direct(const Rows& samples) {
    VariableStepDirectHistory history(interpolating_families, step_plan(grid()));
    return convolutions(history, interpolating_families.size(), samples, times_of(grid()));
  }
  static Matrix exponentials(const Rows& samples, double tolerance) {
    VariableStepExponentialHistory history(interpolating_families, step_plan(grid()), tolerance);
    return convolutions(history, interpolating_families.size(), samples, times_of(grid()));
  }
  static Grid grid() { return {.end = 3.0, .steps = steps, .grading = GetParam()}; }
};

TEST_P(HistoriesOnGradedGrids, Agree) {
  for (const double lowest : {0.5, -1.5}) {
    const Rows samples = random_samples(3, steps, lowest);
    expect_near(exponentials(samples, 1e-15), direct(samples), direct(samples.cwiseAbs()),
                rounding_of_plain_sums(steps));
  }
}

TEST_P(HistoriesOnGradedGrids, AreSmallerForALooserToleranceAndWithinIt) {
  const Rows samples = random_samples(3, steps);
  const Matrix exact = direct(samples);
  expect_near(exponentials(samples, 1e-6), exact, exact, 1e-6);
  EXPECT_LT(VariableStepExponentialHistory(interpolating_families, step_plan(grid()), 1e-6).bytes(),
            VariableStepExponentialHistory(interpolating_families, step_plan(grid()), 1e-15).bytes());
}

INSTANTIATE_TEST_SUITE_P(, HistoriesOnGradedGrids, testing::Values(1.5, 3.0, 6.0));

}  // namespace
}  // namespace fde::bench
