// SPDX-License-Identifier: MIT
// fewest_steps() with errors that are given functions of the number of steps.

#include "fdebench/benchmarks/search/fewest_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace fde::bench {
namespace {

constexpr double accuracy = 1e-6;

// Makes runs whose error at the end is a given function of the steps, and counts them.
struct Errors {
  std::function<double(int steps)> signed_error;
  int made = 0;

  CandidateRun operator()(int steps) {
    ++made;
    const double error = signed_error(steps);
    return {.steps = steps,
            .error = std::abs(error),
            .baseline_error = 1.0,
            .signed_error = error,
            .meets_accuracy = std::abs(error) <= accuracy};
  }
  // Runs with doubled numbers of steps, up to the first within the accuracy.
  std::vector<CandidateRun> refinements() {
    std::vector<CandidateRun> runs{(*this)(4)};
    while (!runs.back().meets_accuracy) runs.push_back((*this)(2 * runs.back().steps));
    return runs;
  }
  CandidateRun fewest(int unit, bool scan) {
    const auto runs = refinements();
    made = 0;
    return fewest_steps(runs, accuracy, unit, scan, [this](int steps) { return (*this)(steps); });
  }
};

TEST(FewestSteps, OfAPowerIsFoundInAFewAttempts) {
  for (const double rate : {0.75, 1.0, 1.5, 2.0, 4.0}) {
    Errors errors{[=](int steps) { return 0.3 * std::pow(steps, -rate); }};
    const double exact = std::pow(0.3 / accuracy, 1.0 / rate);
    const auto found = errors.fewest(1, false);
    EXPECT_TRUE(found.meets_accuracy) << rate;
    EXPECT_GE(found.steps, exact) << rate;
    EXPECT_LE(found.steps, 1.02 * exact + 1.0) << rate;
    EXPECT_LE(errors.made, 5) << rate;
  }
}

TEST(FewestSteps, AreAMultipleOfTheUnit) {
  Errors errors{[](int steps) { return std::pow(steps, -1.2); }};
  const auto found = errors.fewest(20, false);
  EXPECT_EQ(found.steps % 20, 0);
  EXPECT_LE(found.steps, 1.02 * 1e5 + 20.0);
}

// The error passes through 0 at 300 steps and exceeds the accuracy from there to nearly 1000 steps. Numbers
// of steps in a ratio of 1.05 miss the zero.
TEST(FewestSteps, AreFoundWhereTheErrorChangesItsSign) {
  Errors errors{[](int steps) { return 1e-3 * (1.0 - 300.0 / steps) * std::pow(100.0 / steps, 3.0); }};
  ASSERT_GT(errors.fewest(1, false).steps, 800);
  const auto found = errors.fewest(1, true);
  EXPECT_TRUE(found.meets_accuracy);
  EXPECT_LE(found.steps, 308);
  EXPECT_GE(found.steps, 292);
}

TEST(MoreSteps, AreAboutAHundredthMore) {
  EXPECT_EQ(more_steps(10, 1), 12);
  EXPECT_EQ(more_steps(35'400, 1), 35'800);
  EXPECT_EQ(more_steps(100, 20), 120);
}

}  // namespace
}  // namespace fde::bench
