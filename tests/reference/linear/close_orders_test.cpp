// SPDX-License-Identifier: MIT
// Linear systems whose characteristic function loses 20 digits or more by cancellation, since its orders are
// close.

#include <gtest/gtest.h>

#include "fdebench/reference/linear/linear_system.hpp"

namespace fde::reference {
namespace {

Reference of_order(double gamma, const Matrix& matrix, double x0, double y0) {
  return linear_reference({.orders = {gamma, gamma}, .initial = {{x0}, {y0}}, .matrix = matrix});
}

void expect_value(const Reference& reference, const Vec& exact) {
  const ReferenceValue known = reference.at(1.0);
  for (Eigen::Index i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(known.value[i], exact[i], known.bound[i] + 1e-16 * exact[i]);
    EXPECT_LT(known.bound[i], 1e-15 * exact[i]);
  }
}

// mpmath 1.3: E_g(z) = e^(z^(1/g)) / g + int_0^infinity e^-r K(r) dr, the jump of s^(g-1) / (s^g - z) at the
// cut, by quadrature in log r down to -1e13 with 45 digits.

// The zeros of s^2g - 2 s^g + 1 + g^2 are at about log s = +-i, where the terms cancel to 1e-20 of their
// size.
TEST(CloseOrders, TwoZerosOfATinyOrderAreFound) {
  constexpr double gamma = 1e-10;
  const Matrix turning = (Matrix(2, 2) << 1.0, -gamma, gamma, 1.0).finished();
  expect_value(of_order(gamma, turning, 1.0, 0.0), Vec{{6945447373.0401302839, 13713854153.017715070}});
}

TEST(CloseOrders, ADoubleZeroOfATinyOrderIsFound) {
  const Matrix defective = (Matrix(2, 2) << 1.0, 1.0, 0.0, 1.0).finished();
  expect_value(of_order(1e-10, defective, 1.0, 0.5), Vec{{140388512124091313338.5, 11332672538.749244175}});
}

// (s^g - 1)(s^(2-g) + 4) = -1: zeros where s^2 balances the small s^g - 1, at
// s = 825.44406994956 +- 10301.7085936548 i (mpmath's findroot, 30 digits). The values at t = 1e-3 are from
// the transforms by Talbot's contour with 60, 100 and 140 points and 80 digits, which agree to all digits
// given here.
TEST(CloseOrders, AZeroFarFromTheRadiiOfEqualTermsIsFound) {
  const Reference solution = linear_reference({.orders = {1e-9, 2.0 - 1e-9},
                                               .initial = {{1.0}, {0.5, 0.0}},
                                               .matrix = (Matrix(2, 2) << 1.0, 1.0, -1.0, -4.0).finished()});
  const ReferenceValue known = solution.at(1e-3);
  const Vec exact = Vec{{-260023869.06058958365, -3.0585250701993331291}};
  for (Eigen::Index i = 0; i < exact.size(); ++i) {
    const double size = std::abs(exact[i]);
    EXPECT_NEAR(known.value[i], exact[i], known.bound[i] + 2e-16 * size) << i;
    EXPECT_LT(known.bound[i], 1e-15 * size) << i;
  }
}

}  // namespace
}  // namespace fde::reference
