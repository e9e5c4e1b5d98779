// SPDX-License-Identifier: MIT
// The characteristic function of a linear problem: its value and its rounding error.

#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fde::reference {
namespace {

// 10^k (s - 3) divided by its largest term at log s = 1.0986122886682 (a double): 1 - 3/s is
// 9.02408225719086546797918e-14 there (mpmath, 60 digits). In long double log 10^4900 = 11283 has 15 digits
// after the point.
TEST(CharacteristicFunction, ItsNoiseKnowsTheRoundingOfLargeCoefficients) {
  constexpr long double exact = 9.02408225719086546797918e-14L;
  for (int k = 4800; k <= 4900; k += 10) {
    Rational size(1);
    for (int i = 0; i < k; ++i) size *= 10;
    LinearTransform transform;
    add_term(transform.characteristic, Rational(1), size);
    add_term(transform.characteristic, Rational(0), Rational(-3 * size));
    const auto [value, noise, digits] =
        CharacteristicFunction(transform).scaled_value({1.0986122886682, 0.0L});
    EXPECT_LE(std::abs(value - exact), noise + 1e-18L * exact) << k << ' ' << digits;
    EXPECT_LT(noise, 1e-14L) << k;
  }
}

}  // namespace
}  // namespace fde::reference
