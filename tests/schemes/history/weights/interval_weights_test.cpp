// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "schemes/history/weights/exact_weights.hpp"

namespace fde::bench {
namespace {

// int tau^(g-1) dtau and int tau^g dtau over the distances tau = t - s of an interval.
struct Moments {
  Exact near, far, constant, linear;
};
Moments moments(double order, double distance, double length) {
  const Exact g = order, near = distance, far = near + length;
  return {near, far, (power(far, g) - power(near, g)) / g,
          (power(far, g + 1) - power(near, g + 1)) / (g + 1)};
}

// The hat functions of the two ends are (tau - near)/length and (far - tau)/length.
Exact exact_left(double order, double distance, double length) {
  const auto [near, far, constant, linear] = moments(order, distance, length);
  return (linear - near * constant) / (length * tgamma(Exact(order)));
}
Exact exact_right(double order, double distance, double length) {
  const auto [near, far, constant, linear] = moments(order, distance, length);
  return (far * constant - linear) / (length * tgamma(Exact(order)));
}

Exact exact_integral(double order, double distance, double length) {
  return moments(order, distance, length).constant / tgamma(Exact(order));
}

constexpr std::array interval_orders{0.01, 0.3, 0.5, 0.9, 1.0, 1.3, 1.9, 2.0};

// An ulp each for length / far, for the power, for Gamma and for their product; four more in the closed form,
// which subtracts numbers up to 4.5 times the difference (order 2), each with an error of about half an ulp.
constexpr double allowed_interval_ulps = 8.0;

class IntervalWeightsOfOrder : public testing::TestWithParam<double> {
 protected:
  // Calls check(order, distance, length). Lengths other than 1 test the rounding of their powers.
  template <typename Check>
  static void for_intervals(Check check) {
    for (const double length : {1.0, 0.03, 7e-11}) {
      for (const double ratio : {0.0, 1e-12, 1e-3, 0.5, 1.0, 1.0001, 3.0, 1e3, 1e8, 1e12}) {
        SCOPED_TRACE(testing::Message() << "length " << length << ", distance / length " << ratio);
        check(GetParam(), ratio * length, length);
      }
    }
  }
};

TEST_P(IntervalWeightsOfOrder, AreGoodToAFewUlp) {
  for_intervals([](double order, double distance, double length) {
    const auto [left, right] = interval_weights(order, distance, length);
    EXPECT_LE(ulps(left, exact_left(order, distance, length)), allowed_interval_ulps);
    EXPECT_LE(ulps(right, exact_right(order, distance, length)), allowed_interval_ulps);
  });
}

// Both weights are positive, so the relative error of the sum is at most theirs, up to one rounding.
TEST_P(IntervalWeightsOfOrder, SumToTheIntegralOfTheKernel) {
  for_intervals([](double order, double distance, double length) {
    const auto [left, right] = interval_weights(order, distance, length);
    EXPECT_GT(left, 0.0);
    EXPECT_GT(right, 0.0);
    EXPECT_LE(ulps(left + right, exact_integral(order, distance, length)), allowed_interval_ulps + 0.5);
  });
}

INSTANTIATE_TEST_SUITE_P(, IntervalWeightsOfOrder, testing::ValuesIn(interval_orders));

class RulesOnUniformGrids : public testing::TestWithParam<const WeightFamily*> {};

// The weight of a sample from the two intervals beside it. In addition to the error of the interval weights:
// an ulp each for the distance, the power of the step, Gamma and the product. The rounding of the order 1 - g
// of L1 changes its weights by half an ulp per unit of ln k.
TEST_P(RulesOnUniformGrids, WeighAsTheirTables) {
  const auto& family = *GetParam();
  for (const double order : interval_orders) {
    if (family.acts_on_increments && order >= 1.0) continue;
    const WeightTable table{&family, order};
    const double g = integral_order(table);
    for (const double length : {1.0, 0.25, 0.037}) {
      for (const std::int64_t lag : {1, 2, 3, 7, 40, 1000, 1'000'000}) {
        const auto k = static_cast<double>(lag);
        const auto before = interval_weights(g, k * length, length);
        const auto after = interval_weights(g, (k - 1) * length, length);
        const auto rising = family.endpoint_values(0.0, 1.0, length),
                   falling = family.endpoint_values(1.0, 0.0, length);
        const double integral = before.left * rising.left + before.right * rising.right +
                                after.left * falling.left + after.right * falling.right;
        const double allowed =
            allowed_interval_ulps + 4.0 + (family.acts_on_increments ? std::log(k) / 2.0 : 0.0);
        EXPECT_LE(ulps(integral * integral_to_sum_factor(table, length), published_weight(table, lag)),
                  allowed)
            << "order " << order << ", length " << length << ", k " << lag;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RulesOnUniformGrids,
                         testing::Values(&families::rectangle, &families::trapezoid, &families::l1),
                         [](const auto& test) { return std::string(test.param->id); });

}  // namespace
}  // namespace fde::bench
