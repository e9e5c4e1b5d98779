// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/bounded_variable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fde::bench {
namespace {

class BoundedVariables : public testing::TestWithParam<Range> {
 protected:
  const BoundedVariable variable_{GetParam(), 3.0};
};

TEST_P(BoundedVariables, AreFreeWithinTheirRange) {
  for (double z = -20.0; z <= 20.0; z += 0.5) {
    const double theta = variable_.bounded(z);
    EXPECT_TRUE(variable_.has_inside(theta)) << z;
    EXPECT_TRUE(GetParam().contains(theta)) << z;
    const double rounding = 1e-15 * std::exp(std::abs(z));
    EXPECT_NEAR(variable_.free(theta), z, 10.0 * rounding);
  }
}

TEST_P(BoundedVariables, HaveTheSlopeOfTheirDifferences) {
  constexpr double h = 1e-5;
  for (const double z : {-3.0, -0.5, 0.0, 0.7, 4.0}) {
    const double difference = (variable_.bounded(z + h) - variable_.bounded(z - h)) / (2.0 * h);
    EXPECT_NEAR(variable_.slope(z) / difference, 1.0, 1e-8) << z;
  }
}

INSTANTIATE_TEST_SUITE_P(Ranges, BoundedVariables,
                         testing::Values(any_number, positive, Range{.high = -2.0}, order_below_one,
                                         Range{.low = -5.0, .high = 7.0}));

TEST(BoundedVariable, KnowsTheEndsOfItsRange) {
  const BoundedVariable order(order_up_to_two, 1.0);
  EXPECT_FALSE(order.has_inside(0.0));
  EXPECT_FALSE(order.has_inside(2.0));
  EXPECT_FALSE(order.has_inside(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(order.nearest_end(1.4), 2.0);
  EXPECT_EQ(order.nearest_end(0.4), 1e-9);  // 0 itself is no order
  EXPECT_EQ(order.width(), 1.0);
  EXPECT_EQ(BoundedVariable(Range{.low = -5.0}, 3.0).nearest_end(1e6), -5.0);
  EXPECT_FALSE(BoundedVariable(any_number, 1.0).has_bound());
}

}  // namespace
}  // namespace fde::bench
