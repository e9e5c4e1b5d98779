// SPDX-License-Identifier: MIT
// The fit of two powers to errors that are sums of two powers, and to other errors.

#include "fdebench/benchmarks/search/error_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace fde::bench {
namespace {

std::vector<TrialError> errors(const std::function<double(double n)>& error, int coarsest = 16,
                               int count = 5) {
  std::vector<TrialError> made;
  for (int steps = coarsest; count > 0; steps *= 2, --count) made.push_back({steps, error(steps)});
  return made;
}

struct TwoPowers {
  double a, p, b, q;

  [[nodiscard]] double at(double n) const { return a * std::pow(n, -p) + b * std::pow(n, -q); }
};

class ErrorModelOf : public testing::TestWithParam<TwoPowers> {};

TEST_P(ErrorModelOf, TwoPowersHoldsBetweenAndBeyondTheMeasured) {
  const auto truth = GetParam();
  const ErrorModel model(errors([&](double n) { return truth.at(n); }));
  ASSERT_FALSE(model.empty());
  for (const double n : {100.0, 200.0, 300.0})
    EXPECT_NEAR(model.error(n).value / truth.at(n), 1.0, 0.01) << n;
  for (const double n : {1e3, 1e4, 1e5}) {
    const auto expected = model.error(n);
    EXPECT_LE(expected.low, truth.at(n)) << n;
    EXPECT_GE(expected.high, truth.at(n)) << n;
  }
  const auto steps = model.steps(truth.at(4096.0));
  EXPECT_LE(steps.low, 4097.0);
  EXPECT_GE(steps.high, 4095.0);
  EXPECT_NEAR(model.steps(truth.at(200.0)).value, 200.0, 3.0);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, ErrorModelOf,
                         testing::Values(TwoPowers{1.0, 2.0, 0.0, 3.0}, TwoPowers{0.5, 1.5, 8.0, 2.0},
                                         TwoPowers{3.0, 0.5, 1.0, 1.0}, TwoPowers{1.0, 1.0, -4.0, 2.0},
                                         TwoPowers{1e-9, 1.2, 1e-8, 1.8}));

TEST(ErrorModel, OfOneErrorOrOfNoneIsEmpty) {
  EXPECT_TRUE(ErrorModel(errors([](double n) { return 1.0 / n; }, 16, 1)).empty());
  EXPECT_TRUE(ErrorModel({}).empty());
  EXPECT_TRUE(ErrorModel(errors([](double) { return 0.0; })).empty());
}

// Two errors determine one power without an uncertainty.
TEST(ErrorModel, OfTwoErrorsIsTheirPower) {
  const ErrorModel model(errors([](double n) { return 7.0 / (n * n); }, 64, 2));
  EXPECT_NEAR(model.error(1280.0).value, 7.0 / (1280.0 * 1280.0), 1e-9);
}

}  // namespace
}  // namespace fde::bench
