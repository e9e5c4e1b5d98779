// SPDX-License-Identifier: MIT
// Algebraic rows, 0 = f_i, in problems that are solved at all times at once.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/schemes/rules/two_sided/global_solver.hpp"
#include "support/two_sided_problems.hpp"

namespace fde::bench {
namespace {

class TwoSidedAlgebraic : public testing::TestWithParam<const WeightFamily*> {};

TEST_P(TwoSidedAlgebraic, ARowThatDefinesAnUnknownCanBeEliminated) {
  const DefinedUnknown problems;
  const auto a = solve_globally(problems.eliminated, {1.0, 200}, {}, *GetParam());
  const auto b = solve_globally(problems.whole, {1.0, 200}, {}, *GetParam());
  ASSERT_EQ(a.status, SolveStatus::finished);
  ASSERT_EQ(b.status, SolveStatus::finished);
  for (Eigen::Index n = 0; n <= 200; ++n) {
    EXPECT_NEAR(b.y(1, n), a.y(0, n), 1e-13);
    EXPECT_NEAR(b.y(2, n), a.y(1, n), 1e-13);
    EXPECT_NEAR(b.y(0, n), DefinedUnknown::z(a.y.col(n)), 1e-13);
  }
}

// v' = F + a lambda, 0 = a . v: v = (F - a (a . F) / |a|^2) t and lambda = -(a . F) / |a|^2. The right row r,
// -r' = v_1, depends on v only.
TEST_P(TwoSidedAlgebraic, AMultiplierKeepsItsConstraint) {
  const Eigen::Vector2d a(1.0, -0.5), force(0.3, 2.0);
  const double lambda = -a.dot(force) / a.squaredNorm();
  const Problem problem{
      .components = {{1.0, {0.0}}, {1.0, {0.0}}, {0.0, {lambda}}, {1.0, {0.0}, Side::right}},
      .rhs =
          [=](double, In y, Out f) {
            f.head<2>() = force + a * y[2];
            f[2] = a.dot(y.head<2>());
            f[3] = y[0];
          },
      .end = 2.0};
  for (const int steps : {50, 8192}) {
    const auto path = solve_globally(problem, {2.0, steps}, {}, *GetParam());
    ASSERT_EQ(path.status, SolveStatus::finished);
    double drift = 0.0, off = 0.0, multiplier = 0.0;
    for (int n = 0; n <= steps; ++n) {
      const Eigen::Vector2d v = path.y.col(n).head<2>();
      drift = std::max(drift, std::abs(a.dot(v)));
      off = std::max(off, (v - (force + a * lambda) * path.time(n)).norm());
      multiplier = std::max(multiplier, std::abs(path.y(2, n) - lambda));
    }
    EXPECT_LT(drift, 1e-14);
    EXPECT_LT(off, 1e-12);
    EXPECT_LT(multiplier, 1e-8);
    EXPECT_NEAR(path.y(3, 0), 2.0 * (force + a * lambda)[0],
                GetParam() == &families::trapezoid ? 1e-12 : 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(, TwoSidedAlgebraic,
                         testing::Values(&families::trapezoid, &families::grunwald_letnikov),
                         [](const auto& test) {
                           return test.param == &families::trapezoid ? "trapezoid" : "grunwald_letnikov";
                         });

}  // namespace
}  // namespace fde::bench
