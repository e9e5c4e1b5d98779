// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/weights.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "schemes/history/weights/exact_weights.hpp"

namespace fde::bench {
namespace {

std::vector<std::int64_t> lags() {
  std::vector<std::int64_t> result;
  for (std::int64_t k = 1; k <= 40; ++k) result.push_back(k);
  for (double k = 50; k < 1e9; k *= 1.7) result.push_back(static_cast<std::int64_t>(k));
  result.insert(result.end(), {1000, 1'000'000, 999'999'999, 1'000'000'000});
  return result;
}

const std::vector<double> orders{0.01, 0.05, 0.1, 0.2, 0.3,  0.4, 0.5, 0.6, 0.7,  0.8, 0.9,  0.95, 0.99, 1.0,
                                 1.01, 1.1,  1.2, 1.3, 1.35, 1.5, 1.6, 1.7, 1.85, 1.9, 1.95, 1.99, 2.0};

// Where long double has no more digits than double, the rounding of each operation is left.
constexpr double allowed_ulps = std::numeric_limits<long double>::digits > 60 ? 1.0 : 4.0;

struct WorstWeight {
  double ulps = 0.0;
  double order = 0.0;
  std::int64_t lag = 0;
  void update(double error, double at_order, std::int64_t at_lag) {
    if (error > ulps) *this = {error, at_order, at_lag};
  }
  void print(std::string_view what) const {
    fmt::print("{}: worst error {:.2f} ulp, at order {}, k = {}\n", what, ulps, order, lag);
  }
};

class WeightFamilies : public testing::TestWithParam<const WeightFamily*> {};

TEST_P(WeightFamilies, AreGoodToOneUlpUpToABillion) {
  const WeightFamily* const family = GetParam();
  WorstWeight worst;
  for (const double order : orders) {
    if (family->acts_on_increments && order >= 1.0) continue;
    for (const auto lag : lags())
      worst.update(ulps(weight({family, order}, lag), published_weight({family, order}, lag)), order, lag);
  }
  worst.print(family->id);
  EXPECT_LE(worst.ulps, allowed_ulps) << "order " << worst.order << ", k = " << worst.lag;
}

INSTANTIATE_TEST_SUITE_P(, WeightFamilies,
                         testing::Values(&families::rectangle, &families::trapezoid,
                                         &families::grunwald_letnikov, &families::l1,
                                         &families::l1_second_difference, &families::l2_1_sigma,
                                         &families::l2_1_sigma_second_difference),
                         [](const auto& test) { return std::string(test.param->id); });

TEST(StartWeight, IsGoodToOneUlpUpToABillion) {
  WorstWeight worst;
  for (const double order : orders) {
    for (const auto n : lags()) {
      worst.update(ulps(*first_sample_weight({&families::trapezoid, order}, n),
                        published_first_sample_weight(order, n)),
                   order, n);
    }
  }
  worst.print("trapezoid start");
  EXPECT_LE(worst.ulps, allowed_ulps) << "order " << worst.order << ", n = " << worst.lag;
}

TEST(StartWeight, IsNoneForGrunwaldLetnikovAndL1AndThePlainOneForTheRectangleRule) {
  EXPECT_EQ(first_sample_weight({&families::rectangle, 0.3}, 7), std::nullopt);
  EXPECT_EQ(first_sample_weight({&families::grunwald_letnikov, 0.3}, 7), 0.0);
  EXPECT_EQ(first_sample_weight({&families::l1, 0.3}, 7), 0.0);
}

TEST(ConstantWeight, OrderOneHasNoMemory) {
  EXPECT_EQ(constant_weight({&families::rectangle, 1.0}), 1.0);
  EXPECT_EQ(constant_weight({&families::trapezoid, 1.0}), 2.0);
  EXPECT_EQ(constant_weight({&families::grunwald_letnikov, 1.0}), 1.0);
  EXPECT_EQ(constant_weight({&families::l1, 1.0}), 0.0);
  EXPECT_EQ(constant_weight({&families::trapezoid, 0.999}), std::nullopt);
  for (const auto lag : lags()) EXPECT_EQ(weight({&families::trapezoid, 1.0}, lag), 2.0) << lag;
}

// sum of all weights over n steps of f = 1 is the integral of the kernel: n^g, (g+1) n^g, Gamma ratio.
TEST(Weights, OfTheProductRulesIntegrateConstantsExactly) {
  for (const double g : orders) {
    constexpr std::int64_t n = 200;
    double rectangle = 0.0, trapezoid = 1.0 + *first_sample_weight({&families::trapezoid, g}, n);
    for (std::int64_t k = 1; k <= n; ++k) rectangle += weight({&families::rectangle, g}, k);
    for (std::int64_t k = 1; k < n; ++k) trapezoid += weight({&families::trapezoid, g}, k);
    EXPECT_NEAR(rectangle / std::pow(n, g), 1.0, 1e-14) << g;
    EXPECT_NEAR(trapezoid / ((g + 1) * std::pow(n, g)), 1.0, 1e-14) << g;
  }
}

}  // namespace
}  // namespace fde::bench
