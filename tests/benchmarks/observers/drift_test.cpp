// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/drift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fdebench/benchmarks/observers/independent_memory.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// D^order of q with q' = t^p. For order 1 + b: D^b q', which is 0 for p = 0.
double memory_of_power(double order, double p, double t) {
  const double lost = order - 1.0;  // the power p of q' decreases by this much
  if (order > 1.0 && p == 0.0) return 0.0;
  return std::tgamma(p + 1.0) / std::tgamma(p + 1.0 - lost) * std::pow(t, p - lost);
}

Vec power_path(const Grid& grid, double p) {
  Vec v(grid.steps + 1);
  for (int n = 0; n <= grid.steps; ++n) v[n] = std::pow(grid.time(n), p);
  return v;
}

// The largest error over the steps, divided by 1 + |exact|.
double error_of_power(const IndependentMemoryRule& memory, const Grid& grid, double order, double p) {
  double largest = 0.0;
  const Vec v = power_path(grid, p);
  for (int n = 1; n <= grid.steps; ++n) {
    const double exact = memory_of_power(order, p, grid.time(n));
    largest = std::max(largest, std::abs(memory.at(n, v) - exact) / (1.0 + std::abs(exact)));
  }
  return largest;
}

// Eight times per factor of 2, from end/1024 on; a step may pass several of them.
TEST(RunningMaximum, IsSampledEvenlyInTheLogarithmOfTime) {
  RunningMaximum every(1024.0), few(1024.0);
  for (int t = 1; t <= 1024; ++t) every.observe(t, t);
  for (const double t : {0.5, 2.0, 512.0, 1024.0}) few.observe(t, t == 512.0 ? 0.0 : t);
  const auto& [t, value] = every.course();
  EXPECT_EQ(t.front(), 1.0);
  EXPECT_EQ(t.back(), 1020.0) << "to three digits";
  EXPECT_EQ(value, t);
  EXPECT_EQ(std::ranges::count_if(t, [](double at) { return at > 64.0 && at <= 128.0; }), 8);
  EXPECT_EQ(few.course(), (Course{{2.0, 512.0, 1020.0}, {2.0, 2.0, 1020.0}}));
}

TEST(RunningMaximum, HasTheEndsOfEachLevel) {
  RunningMaximum largest(1024.0);
  for (int t = 1; t <= 1024; ++t) largest.observe(t, t < 100 ? 1.0 : 5.0);
  const auto& [t, value] = largest.course();
  EXPECT_EQ(value, (std::vector{1.0, 1.0, 5.0, 5.0}));
  EXPECT_EQ(t.front(), 1.0);
  EXPECT_LT(t[1], 100.0);
  EXPECT_EQ(t.back(), 1020.0);
}

// 0.3117 and 0.3121 are both 0.312 to three digits.
TEST(RunningMaximum, HasEachRoundedTimeOnce) {
  RunningMaximum largest(10.0);
  largest.observe(0.3117, 1.0);
  largest.observe(0.3121, 2.0);
  largest.observe(0.3121 * 1.0001, 3.0);
  largest.observe(0.5, 3.0);
  EXPECT_EQ(largest.course().t, (std::vector{0.312, 0.5}));
}

TEST(RunningMaximum, HasNoTimesWithoutAPositiveValue) {
  RunningMaximum none(1.0);
  for (const double t : {0.5, 1.0}) none.observe(t, 0.0);
  EXPECT_TRUE(none.course().empty());
}

class IndependentMemories : public testing::TestWithParam<double> {
 protected:
  static double order() { return GetParam(); }
  // The starting powers of velocities of constrained motions: integers and multiples of |1 - order|.
  static std::vector<double> powers() {
    const double step = std::abs(1.0 - order());
    return power_lattice({order() < 1.0 ? step : 1.0}, {step, 1.0}, 2.0);
  }
};

TEST_P(IndependentMemories, AreExactForCubics) {
  const Grid grid{.end = 4.0, .steps = 40};
  const IndependentMemoryRule memory(grid, order(), {});
  for (const double p : {0.0, 1.0, 2.0, 3.0}) EXPECT_LT(error_of_power(memory, grid, order(), p), 2e-13) << p;
}

TEST_P(IndependentMemories, AreExactForThePowersOfTheStart) {
  const Grid grid{.end = 4.0, .steps = 40};
  const IndependentMemoryRule memory(grid, order(), powers());
  for (std::size_t p = 0; p < std::min(powers().size(), FittedExponents::most); ++p)
    EXPECT_LT(error_of_power(memory, grid, order(), powers()[p]), 2e-12) << powers()[p];
}

// For v = t^4, v - cubic = h^4 x (x+1) (x-1) (x-2), at the last step h^4 x (x+1) (x+2) (x-1), which are at
// most h^4: so J^b of it is at most h^4 J^b 1. Above order 1 the derivative is of size h^3 and does not
// average out at the last step.
TEST_P(IndependentMemories, HaveOrderFourForSmoothVelocities) {
  const auto error = [](int steps) {
    const Grid grid{.end = 2.0, .steps = steps};
    const double exact = memory_of_power(order(), 4.0, 2.0);
    return std::abs(IndependentMemoryRule(grid, order(), {}).at(steps, power_path(grid, 4.0)) - exact);
  };
  if (order() < 1.0) {
    for (const int steps : {32, 128, 512})
      EXPECT_LT(error(steps), std::pow(2.0 / steps, 4.0) * memory_of_power(order(), 0.0, 2.0)) << steps;
  } else {
    EXPECT_GT(std::log2(error(128) / error(256)), 4.9 - order());
  }
}

TEST_P(IndependentMemories, DoNotBlowUpWhatTheFirstStepsAreOffBy) {
  const Grid grid{.end = 4.0, .steps = 400};
  const IndependentMemoryRule memory(grid, order(), powers()), plain(grid, order(), {});
  double with_start = 0.0, without = 0.0;
  for (int l = 0; l <= 12; ++l) {
    with_start += std::abs(memory.at(400, Vec::Unit(401, l)));
    without += std::abs(plain.at(400, Vec::Unit(401, l)));
  }
  EXPECT_LT(with_start, 12.0 * without);
}

INSTANTIATE_TEST_SUITE_P(, IndependentMemories, testing::Values(0.1, 0.3, 0.5, 0.75, 0.9, 1.2, 1.5, 1.8),
                         [](const auto& test) { return "order_" + std::to_string(int(100 * test.param)); });

TEST(IndependentMemoryRule, NamesWhatItDoesNotTake) {
  const Grid grid{.end = 1.0, .steps = 64};
  EXPECT_THROW(IndependentMemoryRule(grid, 1.0, {}), std::invalid_argument);
  EXPECT_THROW(IndependentMemoryRule(grid, 2.5, {}), std::invalid_argument);
  EXPECT_THROW(IndependentMemoryRule({1.0, 64, 2.0}, 0.5, {}), std::invalid_argument);
  EXPECT_THROW(IndependentMemoryRule({1.0, 15}, 0.5, {}), std::invalid_argument);
}

DriftGrowth course_of(const std::function<double(double)>& drift, int steps = 1000) {
  DriftGrowth course(5.0);
  const Grid grid{.end = 5.0, .steps = steps};
  for (int n = 0; n <= steps; ++n) course.observe(grid.time(n), drift(grid.time(n)));
  return course;
}

TEST(DriftGrowth, GrowsLikeThePowerOfTimeThatItIs) {
  const auto squares = course_of([](double t) { return 1e-6 * t * t; });
  EXPECT_NEAR(squares.growth().value(), 2.0, 1e-12);
  EXPECT_NEAR(squares.largest(), 25e-6, 1e-18);
  EXPECT_NEAR(course_of([](double t) { return 1e-3 * std::sqrt(t); }).growth().value(), 0.5, 1e-12);
}

TEST(DriftGrowth, DoesNotGrowWhereItStaysBoundedOrFalls) {
  EXPECT_NEAR(course_of([](double t) { return std::abs(std::sin(50.0 * t)); }).growth().value(), 0.0, 1e-3);
  EXPECT_EQ(course_of([](double t) { return std::exp(-t); }).growth().value(), 0.0);
}

TEST(DriftGrowth, HasNoGrowthAtRoundingOrWithTooFewSteps) {
  EXPECT_FALSE(course_of([](double t) { return 1e-15 * t; }).growth().has_value());
  EXPECT_FALSE(course_of([](double t) { return t; }, 2).growth().has_value());
}

TEST(DriftGrowth, OfWhatIsNoNumberIsNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(course_of([=](double t) { return t == 2.5 ? none : 1.0; }).largest()));
}

}  // namespace
}  // namespace fde::bench
