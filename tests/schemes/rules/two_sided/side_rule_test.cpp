// SPDX-License-Identifier: MIT
// The rules of the two sides are mirror images.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fdebench/schemes/rules/two_sided/stepped_side.hpp"

namespace fde::bench {
namespace {

struct SideCase {
  const WeightFamily* family;
  HistoryKind history;
};

class SideRules : public testing::TestWithParam<SideCase> {
 protected:
  // The integral of f by the rule of one side.
  static Rows integral(Side side, double order, const Rows& f) {
    const Problem problem{.components = {{order, {}, side}}, .end = 3.0};
    const SteppedSide rule(problem, side, *GetParam().family, {3.0, static_cast<int>(f.cols()) - 1},
                           {.history = GetParam().history});
    Rows value = Rows::Zero(1, f.cols());
    rule.integrate(f, value);
    return value;
  }

  static Rows powers(double exponent, Eigen::Index steps) {
    return Rows::NullaryExpr(1, steps + 1, [&](Eigen::Index, Eigen::Index n) {
      return std::pow(3.0 * static_cast<double>(n) / static_cast<double>(steps), exponent);
    });
  }

  // Column j: the integral of the function that is 1 at time j and 0 at the others.
  static Matrix matrix(Side side, double order, Eigen::Index steps) {
    Matrix columns(steps + 1, steps + 1);
    for (Eigen::Index j = 0; j <= steps; ++j) {
      Rows f = Rows::Zero(1, steps + 1);
      f(0, j) = 1.0;
      columns.col(j) = integral(side, order, f).transpose();
    }
    return columns;
  }
};

TEST_P(SideRules, TheRightIntegralIsTheLeftOneMirroredBitForBit) {
  for (const double order : {0.3, 1.0, 1.6}) {
    for (const double exponent : {0.0, 0.5, 2.0}) {
      const Rows f = powers(exponent, 400);
      EXPECT_EQ(integral(Side::right, order, f.rowwise().reverse()),
                Rows(integral(Side::left, order, f).rowwise().reverse()));
    }
  }
}

TEST_P(SideRules, TheRightMatrixIsTheLeftOneFlipped) {
  for (const double order : {0.3, 1.0, 1.6}) {
    const Matrix left = matrix(Side::left, order, 70), right = matrix(Side::right, order, 70);
    EXPECT_EQ(right, Matrix(left.reverse()));
    // Nothing from later times on the left, nothing from earlier ones on the right.
    EXPECT_TRUE(left.isLowerTriangular(0.0));
    EXPECT_TRUE(right.isUpperTriangular(0.0));
  }
}

// J^g s^p = Gamma(p+1)/Gamma(p+1+g) s^(p+g). The trapezoidal rule is exact for p = 0 and 1.
TEST_P(SideRules, RightIntegralsOfPowersOfTheTimeLeft) {
  const auto error = [](double order, double exponent, Eigen::Index steps) {
    const Rows value = integral(Side::right, order, powers(exponent, steps).rowwise().reverse());
    const Rows exact = std::tgamma(exponent + 1) / std::tgamma(exponent + 1 + order) *
                       powers(exponent + order, steps).rowwise().reverse();
    return std::abs(value(0, steps / 4) - exact(0, steps / 4));
  };
  const bool trapezoid = GetParam().family == &families::trapezoid;
  for (const double order : {0.3, 1.0, 1.6}) {
    for (const double exponent : {1.0, 2.0}) {
      if (trapezoid && exponent == 1.0) {
        EXPECT_LT(error(order, exponent, 800), 1e-13) << order;
      } else {
        EXPECT_NEAR(error(order, exponent, 400) / error(order, exponent, 800), trapezoid ? 4.0 : 2.0, 0.1)
            << order << ' ' << exponent;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, SideRules,
                         testing::Values(SideCase{&families::trapezoid, HistoryKind::direct},
                                         SideCase{&families::trapezoid, HistoryKind::exponentials},
                                         SideCase{&families::grunwald_letnikov, HistoryKind::direct},
                                         SideCase{&families::grunwald_letnikov, HistoryKind::exponentials}),
                         [](const auto& test) {
                           const bool trapezoid = test.param.family == &families::trapezoid;
                           return (trapezoid ? "trapezoid_" : "grunwald_letnikov_") +
                                  std::string(name(test.param.history));
                         });

}  // namespace
}  // namespace fde::bench
