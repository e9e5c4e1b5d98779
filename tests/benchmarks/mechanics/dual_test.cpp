// SPDX-License-Identifier: MIT
// Dual numbers obey the rules of differentiation; nested ones give second derivatives.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/mechanics/dual_derivatives.hpp"

namespace fde::bench::mechanics {
namespace {

constexpr double rounding = 1e-15;

using Plane = Dual<double, 2>;
const double x0 = 0.7, y0 = -1.3;
const Plane x = variable<2>(x0, 0), y = variable<2>(y0, 1);

void expect(const Plane& f, double value, double by_x, double by_y) {
  EXPECT_NEAR(f.value(), value, rounding);
  EXPECT_NEAR(f.derivative(0), by_x, rounding);
  EXPECT_NEAR(f.derivative(1), by_y, rounding);
}

TEST(Dual, ObeysTheRulesOfSumProductAndQuotient) {
  expect(x + y, x0 + y0, 1.0, 1.0);
  expect(x - y, x0 - y0, 1.0, -1.0);
  expect(-x, -x0, -1.0, 0.0);
  expect(x * y, x0 * y0, y0, x0);
  expect(x / y, x0 / y0, 1.0 / y0, -x0 / (y0 * y0));
}

TEST(Dual, ConstantsDoNotMove) {
  expect(3.0 + x, x0 + 3.0, 1.0, 0.0);
  expect(x - 3.0, x0 - 3.0, 1.0, 0.0);
  expect(3.0 - x, 3.0 - x0, -1.0, 0.0);
  expect(3.0 * x, 3.0 * x0, 3.0, 0.0);
  expect(3.0 / y, 3.0 / y0, 0.0, -3.0 / (y0 * y0));
  expect(x + Plane(3.0), x0 + 3.0, 1.0, 0.0);
}

TEST(Dual, SineAndCosineAreEachOthersSlopes) {
  expect(sin(x * y), std::sin(x0 * y0), y0 * std::cos(x0 * y0), x0 * std::cos(x0 * y0));
  expect(cos(x), std::cos(x0), -std::sin(x0), 0.0);
  expect(sin(x) * sin(x) + cos(x) * cos(x), 1.0, 0.0, 0.0);
}

TEST(Dual, AssignmentsAreTheOperationsTheyName) {
  auto f = x;
  f += y;
  f *= x;
  f -= y;
  f /= y;
  const Plane same = ((x + y) * x - y) / y;
  expect(f, same.value(), same.derivative(0), same.derivative(1));
}

TEST(Dual, ComparesByItsValue) {
  EXPECT_TRUE(x > 0.5 && x < 0.8 && variable<2>(x) > 0.5);
  EXPECT_FALSE(x > 0.7);
}

// d^2 (x^2 sin y) / dx dy = 2 x cos y.
TEST(Dual, NestedGivesSecondDerivatives) {
  const auto outer_x = variable<2>(x, 0), outer_y = variable<2>(y, 1);
  const auto f = outer_x * outer_x * sin(outer_y);
  EXPECT_NEAR(f.derivative(0).derivative(1), 2.0 * x0 * std::cos(y0), rounding);
  EXPECT_NEAR(f.derivative(1).derivative(0), 2.0 * x0 * std::cos(y0), rounding);
  EXPECT_NEAR(f.derivative(0).derivative(0), 2.0 * std::sin(y0), rounding);
  EXPECT_NEAR(f.derivative(1).derivative(1), -x0 * x0 * std::sin(y0), rounding);
}

template <int n>
void expect_identity(const Table<Plane, n, n>& product) {
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      EXPECT_NEAR(product(i, j).value(), i == j ? 1.0 : 0.0, 4 * rounding);
      for (const int direction : {0, 1}) EXPECT_NEAR(product(i, j).derivative(direction), 0.0, 8 * rounding);
    }
  }
}

TEST(DualMatrix, TimesItsInverseIsTheIdentityWhateverMoves) {
  expect_identity<1>(Vector<Plane, 1>(x) * Vector<Plane, 1>(x).inverse());
  const auto a = Table<Plane, 3, 3>::filled(
      [](int i, int j) { return i == j ? 2.0 + x * y : sin(x + (i - 2.0 * j) * y); });
  expect_identity<3>(a * a.inverse());
  expect_identity<3>(a.inverse() * a);
}

TEST(DualMatrix, DiagonalOnesAreTheSameInFull) {
  const Diagonal<Plane, 2> diagonal({2.0 + x, y});
  const Table<Plane, 2, 2> full = diagonal, inverse = diagonal.inverse();
  expect_identity<2>(full * inverse);
  expect_identity<2>(diagonal * inverse);
}

}  // namespace
}  // namespace fde::bench::mechanics
