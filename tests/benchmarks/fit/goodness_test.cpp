// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/goodness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fde::bench {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Two columns at three times; one value is missing. Differences from 0: 3, 4 and 0 sds 1, 2, 2; 2, 2, sds
// 0.5.
ExternalTrajectory two_columns() {
  return {.columns = {0, 2},
          .times = {1.0, 2.0, 3.0},
          .values = Rows{{3.0, 4.0, 0.0}, {2.0, missing, 2.0}},
          .deviations = Rows{{1.0, 2.0, 2.0}, {0.5, missing, 0.5}}};
}

TEST(Misfits, AreByColumnWithoutMissingValues) {
  const auto found = misfits(two_columns(), Rows::Zero(2, 3));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].count, 3);
  EXPECT_DOUBLE_EQ(found[0].rms(), 5.0 / std::sqrt(3.0));
  EXPECT_EQ(found[1].column, 2);
  EXPECT_EQ(found[1].count, 2);
  EXPECT_DOUBLE_EQ(found[1].rms(), 2.0);
}

TEST(ChiSquares, CountSquaresInStandardDeviations) {
  const auto chi = chi_squared(two_columns(), Rows::Zero(2, 3), 2);
  EXPECT_DOUBLE_EQ(chi.value, 9.0 + 4.0 + 16.0 + 16.0);
  EXPECT_EQ(chi.degrees, 3);
}

// With two degrees of freedom the probability is exp(-x / 2); with one, x = z^2 of the normal distribution,
// erfc(z / sqrt(2)).
TEST(ChiSquares, HaveTheirProbability) {
  for (const double x : {0.0, 0.5, 3.0, 40.0}) {
    EXPECT_NEAR((ChiSquared{x, 2}.probability().value() / std::exp(-0.5 * x)), 1.0, 1e-14);
    EXPECT_NEAR((ChiSquared{x, 1}.probability().value() / std::erfc(std::sqrt(0.5 * x))), 1.0, 1e-14);
  }
  EXPECT_FALSE((ChiSquared{1.0, 0}.probability()));
}

}  // namespace
}  // namespace fde::bench
