// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/robustness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <tuple>
#include <vector>

namespace fde::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<MedianInterval> timed(double seconds, double spread = 0.0) {
  return MedianInterval{seconds, seconds - spread, seconds + spread};
}

// Newcombe, Two-sided confidence intervals for the single proportion, Statistics in Medicine 17 (1998),
// table I, method 3: 81/263, 15/148, 0/20, 1/29.
TEST(WilsonShare, HasTheIntervalsOfNewcombesTable) {
  const auto check = [](std::size_t k, std::size_t n, double low, double high) {
    const auto share = wilson_share(k, n);
    EXPECT_DOUBLE_EQ(share.value, static_cast<double>(k) / static_cast<double>(n));
    EXPECT_NEAR(share.low, low, 5e-5) << k << "/" << n;
    EXPECT_NEAR(share.high, high, 5e-5) << k << "/" << n;
  };
  check(81, 263, 0.2553, 0.3662);
  check(15, 148, 0.0624, 0.1605);
  check(0, 20, 0.0, 0.1611);
  check(1, 29, 0.0061, 0.1718);
}

// Of the values 1 ... 100, ranks of the binomial numbers of 100 trials: 40 and 61 of the median, as tables of
// the sign test have them; 90 and 99 of the 95 % quantile, by P(B < 90) = 1.1 %, P(B < 91) = 2.8 %, P(B >=
// 99) = 3.7 %, P(B = 100) = 0.6 %: the upper rank is 100.
TEST(QuantileOf, HasTheRanksOfBinomialNumbers) {
  std::vector<double> values(100);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 100.0 - static_cast<double>(i);
  const auto median = quantile_of(values, 0.5, 0.0), tail = quantile_of(values, 0.95, 0.0);
  EXPECT_EQ(median.value, 50.0);
  EXPECT_EQ(median.low, 40.0);
  EXPECT_EQ(median.high, 61.0);
  EXPECT_EQ(tail.value, 95.0);
  EXPECT_EQ(tail.low, 90.0);
  EXPECT_EQ(tail.high, 100.0);
}

// 0.95^71 > 2.5 % > 0.95^72.
TEST(QuantileOf, HasNoUpperBoundOfTheTailBelow72Values) {
  for (const std::size_t count : {1U, 20U, 71U})
    EXPECT_EQ(quantile_of(std::vector(count, 2.0), 0.95, 1.0).high, infinity) << count;
  EXPECT_EQ(quantile_of(std::vector(72, 2.0), 0.95, 1.0).high, 2.0);
  EXPECT_EQ(quantile_of({3.0}, 0.5, 1.0).low, 1.0) << "the least that it can be";
}

// The part of `trials` in which `covers` holds is within four standard deviations of `expected`, and that is
// not below 95 % by more than `short_of`.
void expect_coverage(double expected, double short_of, const std::function<bool(std::mt19937&)>& covers) {
  constexpr int trials = 4000;
  std::mt19937 random(20261128);
  int covered = 0;
  for (int trial = 0; trial < trials; ++trial) covered += covers(random) ? 1 : 0;
  EXPECT_NEAR(covered / double{trials}, expected, 4 * std::sqrt(expected * (1 - expected) / trials));
  EXPECT_GE(expected, 0.95 - short_of);
}

double binomial(std::size_t n, double p, std::size_t k) {
  const auto of = static_cast<double>(n), some = static_cast<double>(k);
  return std::exp(std::lgamma(of + 1) - std::lgamma(some + 1) - std::lgamma(of - some + 1) +
                  some * std::log(p) + (of - some) * std::log1p(-p));
}

double binomial_between(std::size_t n, double p, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t k = first; k <= last; ++k) sum += binomial(n, p, k);
  return sum;
}

// Wilson's interval covers p with a probability near 95 %, which oscillates with p and n.
TEST(WilsonShare, CoversAsOftenAsBinomialNumbersSay) {
  constexpr std::size_t n = 60;
  for (const double p : {0.1, 0.35, 0.8}) {
    const auto covers = [&](std::size_t k) {
      const auto share = wilson_share(k, n);
      return share.low <= p && p <= share.high;
    };
    double expected = 0.0;
    for (std::size_t k = 0; k <= n; ++k) expected += covers(k) ? binomial(n, p, k) : 0.0;
    std::binomial_distribution<std::size_t> draw(n, p);
    expect_coverage(expected, 0.03, [&](std::mt19937& random) { return covers(draw(random)); });
  }
}

// 1 + an exponential number: its p-quantile is 1 - log(1 - p). The ranks l, u cover it with P(l <= B < u).
TEST(QuantileOf, CoversAsOftenAsItsRanksSay) {
  constexpr std::size_t n = 150;
  std::vector<double> ranks(n);
  for (std::size_t i = 0; i < n; ++i) ranks[i] = static_cast<double>(i + 1);
  std::exponential_distribution<double> draw(1.0);
  for (const double p : {0.5, 0.95}) {
    const auto at = quantile_of(ranks, p, 0.0);
    const double expected =
        binomial_between(n, p, static_cast<std::size_t>(at.low), static_cast<std::size_t>(at.high) - 1);
    expect_coverage(expected, 0.0, [&](std::mt19937& random) {
      std::vector<double> values(n);
      std::ranges::generate(values, [&] { return 1.0 + draw(random); });
      const auto found = quantile_of(values, p, 1.0);
      const double quantile = 1.0 - std::log1p(-p);
      return found.low <= quantile && quantile <= found.high;
    });
  }
}

// Line 0 takes 1, 2 or 3 times the least time, line 1 is the quickest or 1.1 times it and fails once.
TEST(RobustnessOf, CountsWinsTiesAndScenesThatNoLineSolves) {
  const auto found = robustness_of({{timed(1.0), timed(1.1), {}},
                                    {timed(2.0), timed(1.0), {}},
                                    {timed(3.0), timed(1.0), {}},
                                    {timed(1.0), {}, {}},
                                    {timed(1.05, 0.1), timed(1.0, 0.1), {}},
                                    {{}, {}, {}}});
  EXPECT_EQ(found.scenes, 5U);
  EXPECT_EQ(found.unsolved, 1U);
  EXPECT_EQ(found.tied, 1U);
  ASSERT_EQ(found.lines.size(), 2U) << "the third solves nothing";
  const auto& [always, mostly] = std::tie(found.lines[0], found.lines[1]);
  EXPECT_EQ(always.line, 0U);
  EXPECT_EQ(always.solved, 5U);
  EXPECT_EQ(always.won, 2U);
  EXPECT_DOUBLE_EQ(always.near.value, 0.6);
  EXPECT_DOUBLE_EQ(always.median.value, 1.05);
  EXPECT_DOUBLE_EQ(always.tail.value, 3.0);
  EXPECT_EQ(mostly.solved, 4U);
  EXPECT_EQ(mostly.won, 2U);
  EXPECT_DOUBLE_EQ(mostly.near.value, 0.8);
  EXPECT_DOUBLE_EQ(mostly.median.value, 1.0);
  EXPECT_EQ(mostly.tail.value, infinity) << "a scene that it does not solve";
  EXPECT_THAT(found.undecided, testing::ElementsAre(1U)) << "five scenes do not decide";
}

// Of 200 scenes: line 0 takes 2 times the least time everywhere, line 1 is quickest but in every tenth, where
// it takes 9 times as long. So it wins most and is not the one to take.
TEST(RobustnessOf, TakesTheLeastTailAndSaysWhatIsDecided) {
  TimesOfScenes times;
  for (int scene = 0; scene < 200; ++scene) {
    times.push_back(scene % 10 == 0 ? TimesOfScenes::value_type{timed(2.0), timed(9.0), timed(1.0)}
                                    : TimesOfScenes::value_type{timed(2.0), timed(1.0), timed(2.001)});
  }
  const auto found = robustness_of(times);
  ASSERT_EQ(found.lines.size(), 3U);
  EXPECT_EQ(found.lines[0].line, 0U);
  EXPECT_DOUBLE_EQ(found.lines[0].tail.value, 2.0);
  EXPECT_EQ(found.lines[1].line, 2U);
  EXPECT_EQ(found.lines[2].line, 1U);
  EXPECT_EQ(found.lines[2].won, 180U);
  EXPECT_DOUBLE_EQ(found.lines[2].tail.value, 9.0);
  EXPECT_THAT(found.undecided, testing::IsEmpty());
}

TEST(RobustnessOf, IsNothingWithoutTimes) {
  EXPECT_EQ(robustness_of({}).scenes, 0U);
  EXPECT_EQ(robustness_of({{{}}, {{}}}).unsolved, 2U);
}

}  // namespace
}  // namespace fde::bench
