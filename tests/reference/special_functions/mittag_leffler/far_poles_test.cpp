// SPDX-License-Identifier: MIT
// Poles s^alpha = z of large modulus in the left half-plane, close to every contour there: e^s is negligible,
// and the value is the asymptotic expansion -sum_k z^-k / Gamma(beta - k alpha).

#include <gtest/gtest.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::reference {
namespace {

TEST(FarPoles, LeaveTheExpansionForLargeArguments) {
  // mpmath, 60 digits, seven terms.
  const auto [re, im, bound] = mittag_leffler("0.5", "0.3", "-1", "-5e20", 25);
  EXPECT_EQ(re.substr(0, 20), "-1.62311332255946752");
  EXPECT_EQ(im.substr(0, 20), "3.435748076898669849");
}

TEST(FarPoles, AreNothingHoweverFar) {
  for (const double size : {1e16, 1e20, 1e81, 1e200, 1e300}) {
    for (const double part : {-1.0, 0.0, 1.0}) {
      const auto [value, bound] = mittag_leffler(0.5, 0.3, {part, -size});
      const double expected = -1.0 / (size * std::tgamma(-0.2));
      EXPECT_NEAR(value.imag() / expected, 1.0, 1e-14) << size << ' ' << part;
      EXPECT_LT(bound, 1e-15 * std::abs(expected)) << size << ' ' << part;
    }
  }
}

// E_{1,1}(z) = e^z has no other part. mpmath, 40 digits.
TEST(FarPoles, AreAllOfTheExponential) {
  EXPECT_EQ(mittag_leffler("1", "1", "-1e7", "0", 12).re, "1.51693678090e-4342945");
  EXPECT_EQ(mittag_leffler("1", "1", "-1e9", "0", 12).re, "1.24953427192e-434294482");
  // Below all exponents of MPFR.
  EXPECT_THROW(mittag_leffler("1", "1", "-1e19", "0", 12), std::runtime_error);
}

}  // namespace
}  // namespace fde::reference
