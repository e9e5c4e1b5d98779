// SPDX-License-Identifier: MIT
// Variable steps, rejected steps, and user-defined weight families.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "fdebench/schemes/history/history.hpp"

namespace fde::bench {
namespace {

const WeightTables variable_step_families{
    {{&families::rectangle, 0.3}, {&families::rectangle, 1.0}, {&families::rectangle, 1.7}},
    {{&families::trapezoid, 0.3}, {&families::trapezoid, 1.0}, {&families::trapezoid, 1.7}},
    {{&families::l1, 0.3}, {&families::l1, 1.0}, {&families::trapezoid, 2.0}}};

using Times = std::vector<double>;

Times after_steps(const std::vector<double>& lengths) {
  Times times{0.0};
  for (const double length : lengths) times.push_back(times.back() + length);
  return times;
}

// Step sizes that shrink, that are random over five powers of ten, and that return to the shortest after each
// long step.
std::vector<Times> hard_times() {
  std::vector<double> shrinking, random, saw;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> powers(-5.0, 0.0);
  for (int n = 0; n < 120; ++n) {
    shrinking.push_back(std::pow(0.9, n));
    random.push_back(std::pow(10.0, powers(generator)));
    saw.push_back(n % 4 == 3 ? 1.0 : 1e-4);
  }
  return {after_steps(shrinking), after_steps(random), after_steps(saw)};
}

StepPlan plan_of(const Times& times) {
  double shortest = times[1];
  for (std::size_t n = 1; n < times.size(); ++n) shortest = std::min(shortest, times[n] - times[n - 1]);
  return {.end = times.back(), .min_step = shortest};
}

Vec sample_at(double t) { return Vec{{1.0 + 0.5 * std::sin(t), 1.3 + 0.2 * std::cos(3.0 * t), 1.0}}; }

Matrix sums_at(const History& history, double t) {
  Matrix sums(3, static_cast<Eigen::Index>(variable_step_families.size()));
  for (Eigen::Index sum = 0; sum < sums.cols(); ++sum) {
    history.convolve(t, static_cast<std::size_t>(sum), sums.col(sum));
  }
  return sums;
}

// The sums at every time; before each, `reject` may evaluate sums at times that are not pushed.
template <typename Reject>
std::vector<Matrix> along(const Times& times, HistoryKind kind, double tolerance, Reject reject) {
  const auto history = make_history(kind, variable_step_families, plan_of(times), tolerance);
  std::vector<Matrix> sums;
  for (std::size_t n = 1; n < times.size(); ++n) {
    history->push(times[n - 1], sample_at(times[n - 1]));
    reject(*history, times[n - 1], times[n]);
    sums.push_back(sums_at(*history, times[n]));
  }
  return sums;
}
constexpr auto nothing = [](const History& /*history*/, double /*from*/, double /*to*/) {};

TEST(VariableSteps, OfAnyLengthGiveTheDirectSums) {
  for (const auto& times : hard_times()) {
    const auto direct = along(times, HistoryKind::direct, 1e-15, nothing);
    for (const double tolerance : {1e-14, 1e-6}) {
      const auto sums = along(times, HistoryKind::exponentials, tolerance, nothing);
      for (std::size_t n = 0; n < sums.size(); ++n) {
        const Matrix off = (sums[n] - direct[n]).cwiseAbs() - 10.0 * tolerance * direct[n].cwiseAbs();
        ASSERT_LE(off.maxCoeff(), 0.0) << "tolerance " << tolerance << ", step " << n + 1;
      }
    }
  }
}

// Rejected steps that are longer and shorter than the accepted step, and no rejected steps.
TEST(VariableSteps, LeaveNoTraceWhenTheyAreRejected) {
  for (const auto kind : {HistoryKind::direct, HistoryKind::exponentials}) {
    for (const auto& times : hard_times()) {
      const double shortest = plan_of(times).min_step;
      const auto reject = [&](const History& history, double from, double to) {
        for (const double t : {from + shortest, to + 0.5, from + 2.0 * shortest}) sums_at(history, t);
      };
      EXPECT_EQ(along(times, kind, 1e-15, reject), along(times, kind, 1e-15, nothing)) << name(kind);
    }
  }
}

TEST(VariableSteps, MayBePushedWithoutBeingAskedFor) {
  const Times times = hard_times()[1];
  for (const auto kind : {HistoryKind::direct, HistoryKind::exponentials}) {
    const auto history = make_history(kind, variable_step_families, plan_of(times), 1e-15);
    for (std::size_t n = 0; n + 1 < times.size(); ++n) history->push(times[n], sample_at(times[n]));
    EXPECT_EQ(sums_at(*history, times.back()), along(times, kind, 1e-15, nothing).back()) << name(kind);
  }
}

TEST(VariableSteps, ThatAreEqualGiveTheSumsOfEqualSteps) {
  const Times times = after_steps(std::vector<double>(300, 0.25));
  StepPlan equal = plan_of(times);
  equal.uniform = true;
  const auto history = make_history(HistoryKind::exponentials, variable_step_families, equal, 1e-15);
  const auto sums = along(times, HistoryKind::exponentials, 1e-15, nothing);
  for (std::size_t n = 1; n < times.size(); ++n) {
    history->push(times[n - 1], sample_at(times[n - 1]));
    const Matrix expected = sums_at(*history, times[n]);
    ASSERT_LE(((sums[n - 1] - expected).cwiseAbs() - 1e-13 * expected.cwiseAbs()).maxCoeff(), 0.0) << n;
  }
}

// A family that only has the members needed for equal steps and direct sums.
constexpr WeightFamily halving{.id = "halving",
                               .title = "2^(-k), for a test",
                               .weight = [](long double /*g*/, long double k) { return std::exp2(-k); },
                               .step_factor = [](long double /*g*/) { return 1.0L; }};

TEST(AFamilyOfOnesOwn, IsConvolvedAsItsWeightsSay) {
  const StepPlan steps{.end = 1000.0, .min_step = 1.0, .uniform = true};
  const auto history = make_history(HistoryKind::automatic, {{{&halving, 1.0}}}, steps, 1e-15);
  Vec result(1);
  for (int n = 1; n <= 50; ++n) {
    history->push(n - 1.0, Vec::Ones(1));
    history->convolve(n, 0, result);
    EXPECT_NEAR(result[0], 1.0 - std::exp2(-n), 1e-15) << n;
  }
}

TEST(AFamilyOfOnesOwn, IsRefusedWhereItHasNoForm) {
  const StepPlan equal{.end = 10.0, .min_step = 1.0, .uniform = true},
      differing{.end = 10.0, .min_step = 1.0};
  const WeightTables tables{{{&halving, 0.5}}};
  EXPECT_THROW(make_history(HistoryKind::exponentials, tables, equal, 1e-15), std::invalid_argument);
  EXPECT_THROW(make_history(HistoryKind::direct, tables, differing, 1e-15), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
