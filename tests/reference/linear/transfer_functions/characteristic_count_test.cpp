// SPDX-License-Identifier: MIT
// The number of zeros of a characteristic function in a rectangle of log s.

#include <gtest/gtest.h>

#include <numbers>

#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"

namespace fde::reference {
namespace {

// (s^2 + 1)(s^2 + 1 + apart) = s^4 + (2 + apart) s^2 + 1 + apart.
CharacteristicFunction two_pairs(const Rational& apart) {
  LinearTransform transform;
  add_term(transform.characteristic, Rational(4), Rational(1));
  add_term(transform.characteristic, Rational(2), Rational(2 + apart));
  add_term(transform.characteristic, Rational(0), Rational(1 + apart));
  return CharacteristicFunction(transform);
}

// Zeros at log s = +-i pi/2 and +-i pi/2 + log(1 + apart)/2: four left of a side that passes all of them on
// the right, none left of a side that passes them on the left. At each pair arg P changes by nearly 2 pi
// within a length of a few distances, which the values at the ends of a longer piece do not show.
TEST(CharacteristicCount, TwoZerosCloseToEachOtherNextToASideAreTwo) {
  for (const int digits : {3, 5, 7}) {
    long double distance = 1.0L;
    Rational apart(1);
    for (int i = 0; i < digits; ++i) {
      apart /= 10;
      distance /= 10.0L;
    }
    const CharacteristicFunction function = two_pairs(apart);
    for (const long double beyond : {0.1L, 0.07L, 0.13L, 0.04L}) {
      const long double height = std::numbers::pi_v<long double> + beyond;
      EXPECT_EQ(count_zeros(function, {-1.0L, distance, height}), 4) << digits << ' ' << beyond;
      EXPECT_EQ(count_zeros(function, {-1.0L, -distance, height}), 0) << digits << ' ' << beyond;
      EXPECT_EQ(count_zeros(function, {-distance, 1.0L, height}), 4) << digits << ' ' << beyond;
      EXPECT_EQ(count_zeros(function, {distance, 1.0L, height}), 0) << digits << ' ' << beyond;
    }
  }
}

}  // namespace
}  // namespace fde::reference
