// SPDX-License-Identifier: MIT
// Bounds as texts of two digits: never below the number, and compared beyond the range of double.

#include "fdebench/benchmarks/references/decimal_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace fde::bench {
namespace {

TEST(WrittenBound, IsNeverBelowTheNumberAndAtMostTwelvePercentAbove) {
  for (int k = 0; k < 2000; ++k) {
    const double bound = 1e-9 * std::pow(10.0, k / 499.0);
    const double written = std::stod(bound_text(bound));
    EXPECT_GE(written, bound);
    EXPECT_LE(written, 1.12 * bound);
  }
  EXPECT_EQ(bound_text(0.0), "0");
  EXPECT_EQ(bound_text(std::numeric_limits<double>::infinity()), "inf");
}

// 0.1 is written as 0.10000000000000001, which differs from the double by 0.45e-17.
TEST(BoundOfText, HoldsForTheDecimal) {
  EXPECT_GE(bound_of_decimal(0.1, 0.0), 0.44e-17);
  EXPECT_LE(bound_of_decimal(0.1, 0.0), 0.46e-17);
  EXPECT_EQ(bound_of_decimal(0.5, 0.25), 0.25);
  EXPECT_EQ(bound_of_decimal(std::numeric_limits<double>::infinity(), 1.0), 1.0);
}

TEST(FiniteBound, IsANumberOfAnySize) {
  for (const auto* finite : {"0", "0.012", "1.2e-9999999999", "1e+308", "2.9e+9999999999"})
    EXPECT_TRUE(is_finite_bound(finite)) << finite;
  for (const auto* other : {"inf", "nan", "-nan"}) EXPECT_FALSE(is_finite_bound(other)) << other;
}

// Each is smaller than the next.
TEST(LargerBound, OrdersWhatNoDoubleHolds) {
  const std::vector<std::string> rising{"0",       "1.2e-6868", "9.9e-6868", "1e-6867", "9.9e-05",
                                        "0.00012", "0.5",       "1.2",       "1.3",     "99",
                                        "1e+02",   "2.9e+6868", "3e+6868",   "inf"};
  for (std::size_t i = 0; i < rising.size(); ++i) {
    for (std::size_t j = 0; j < rising.size(); ++j)
      EXPECT_EQ(larger_bound(rising[i], rising[j]), rising[std::max(i, j)]) << rising[i] << ", " << rising[j];
  }
  EXPECT_EQ(larger_bound("1e+99", "nan"), "nan");
  EXPECT_THROW(larger_bound("1", "x"), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
