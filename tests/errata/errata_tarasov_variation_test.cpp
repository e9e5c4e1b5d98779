// SPDX-License-Identifier: MIT
// Tarasov & Zaslavsky 2006, the variational side: the Helmholtz conditions, eq. 38 and eqs 70-86.

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "fdebench/reference/linear/linear_system.hpp"
#include "support/caputo.hpp"

namespace fde::bench {
namespace {

using Eigen::Vector2d;

// Lambda = -grad u with u = q1^2/2 + q1 q2 + q2^2 has a potential; the printed condition adds its
// derivatives.
TEST(ErrataTarasov, HelmholtzConditionHasAPlusForAMinus) {
  const Eigen::Matrix2d by_q = -(Eigen::Matrix2d() << 1.0, 1.0, 1.0, 2.0).finished();  // dLambda_k / dq_m
  const double right = 0.0;  // no velocity in Lambda
  EXPECT_EQ(by_q(0, 1) - by_q(1, 0), right);
  EXPECT_EQ(by_q(0, 1) + by_q(1, 0), -2.0);
}

// A magnetic force B(q) (q2', -q1') has a generalised potential for every B, here q1^2 + 3 q2.
TEST(ErrataTarasov, HelmholtzConditionHoldsForMagneticForcesWithTheMinus) {
  const Vector2d q(0.4, -1.1), v(0.7, 0.2), gradient(2.0 * q[0], 3.0);
  const double by_q2 = gradient[1] * v[1], by_q1 = -gradient[0] * v[0];  // dLambda_1/dq2, dLambda_2/dq1
  const double right = 0.5 * (2.0 * gradient.dot(v));                    // half of d/dt (B - (-B))
  EXPECT_NEAR(by_q2 - by_q1, right, 1e-15);
  EXPECT_GT(std::abs(by_q2 + by_q1 - right), 1.0);
}

// a.q' = C0 in a potential u: q'' = -grad u + R conserves a.q' with R = lambda a, not with R = a.
TEST(ErrataTarasov, ReactionOfEquation38LacksItsMultiplier) {
  const Vector2d a(1.0, 2.0), slope(0.3, -1.0);
  const double lambda = a.dot(slope) / a.squaredNorm();
  EXPECT_NEAR(a.dot(-slope + lambda * a), 0.0, 1e-15);
  EXPECT_GT(a.dot(-slope + a), 6.0);
}

// S = 1/2 int_0^1 (D^(1/2) q)^2 at q = t, in the direction e = t (1 - t), which vanishes at both ends.
TEST(ErrataTarasov, Equation70KeepsTheLeftDerivative) {
  const double order = 0.5;
  const auto momentum = [&](double t) { return caputo_derivative_of_power(1.0, order, t); };  // of D^(1/2) q
  const auto direction = [](double t) { return t * (1.0 - t); };
  const double exact = integral(
      [&](double t) {
        return momentum(t) *
               (caputo_derivative_of_power(1.0, order, t) - caputo_derivative_of_power(2.0, order, t));
      },
      0.0, 1.0);
  EXPECT_NEAR(exact, 0.0707355302631, 1e-12);
  // The right Riemann-Liouville derivative; the direction vanishes at 1 and cancels its singularity
  // (1 - t)^(-1/2).
  const auto slope = [](double t) { return 1.0 / (2.0 * reference::gamma(1.5) * std::sqrt(t)); };
  const double adjoint = integral(
      [&](double t) { return direction(t) * right_riemann_liouville(slope, momentum(1.0), order, t, 1.0); },
      0.0, 1.0);
  EXPECT_NEAR(adjoint, exact, 1e-10);
  const double printed = integral(
      [&](double t) {
        return direction(t) * caputo_derivative_of_power(0.5, order, t) / reference::gamma(1.5);
      },
      0.0, 1.0);
  EXPECT_NEAR(printed, 1.0 / 6.0, 1e-12);
}

// The other term: int_0^1 M tD_1^a e = int_0^1 e (left Riemann-Liouville D^a M), M = 1 + t, a = 0.3.
TEST(ErrataTarasov, Equation70KeepsTheRightDerivative) {
  const double order = 0.3;
  const auto direction = [](double t) { return t * (1.0 - t); };
  const auto slope = [](double t) { return 1.0 - 2.0 * t; };
  const double exact =
      integral([&](double t) { return (1.0 + t) * right_caputo(slope, order, t, 1.0); }, 0.0, 1.0);
  const double adjoint = integral(
      [&](double t) {
        const double of_constant = std::pow(t, -order) / reference::gamma(1.0 - order);
        return direction(t) * (of_constant + caputo_derivative_of_power(1.0, order, t));
      },
      0.0, 1.0);
  EXPECT_NEAR(adjoint, exact, 1e-11);
  const double printed = integral(
      [&](double t) { return direction(t) * right_caputo([](double) { return 1.0; }, order, t, 1.0); }, 0.0,
      1.0);
  EXPECT_GT(std::abs(printed - exact), 0.1);
}

// Eq. 82 inherits the error: for mu A q' = mu D^a q q' the derivative with respect to D^a q is mu q', and the
// variation of the action contains the right derivative of mu q'. q = t^2, mu = 1, a = 1/2: int 2t D^(1/2) e.
TEST(ErrataTarasov, Equation82InheritsTheLeftDerivative) {
  const double order = 0.5;
  const auto direction = [](double t) { return t * (1.0 - t); };
  const double exact = integral(
      [&](double t) {
        return 2.0 * t *
               (caputo_derivative_of_power(1.0, order, t) - caputo_derivative_of_power(2.0, order, t));
      },
      0.0, 1.0);
  const double adjoint = integral(
      [&](double t) {
        return direction(t) * right_riemann_liouville([](double) { return 2.0; }, 2.0, order, t, 1.0);
      },
      0.0, 1.0);
  EXPECT_NEAR(adjoint, exact, 1e-11);
  const double printed = integral(
      [&](double t) { return direction(t) * 2.0 * caputo_derivative_of_power(1.0, order, t); }, 0.0, 1.0);
  EXPECT_GT(std::abs(printed - exact), 0.1);
}

// H = (p^2 + q^2)/2 from q = 1, p = 0: with p' = +q the solution grows like cosh t.
TEST(ErrataTarasov, Equation78HasTheWrongSignOfTheForce) {
  const auto at = [](double sign, double t) -> Vector2d {
    const Matrix flow = (Matrix(2, 2) << 0.0, 1.0, sign, 0.0).finished();
    return reference::linear_reference(
               reference::LinearSystem{.orders = {1.0, 1.0}, .initial = {{1.0}, {0.0}}, .matrix = flow})
        .at(t)
        .value;
  };
  const double t = 3.0;
  EXPECT_NEAR(0.5 * at(-1.0, t).squaredNorm(), 0.5, 1e-14);
  EXPECT_NEAR(at(-1.0, t)[0], std::cos(t), 1e-14);
  EXPECT_NEAR(at(1.0, t)[0], std::cosh(t), 1e-13);
}

// The projection of p in eq. 85 does not depend on the length of A: A -> 0 does not give q' = p.
TEST(ErrataTarasov, Equation86HasNoLimitWithoutTheConstraint) {
  const Vector2d p(0.6, -0.8), direction(1.0, 3.0);
  const auto velocity = [&](double size) -> Vector2d {
    const Vector2d a = size * direction;
    return p - a * (a.dot(p) / a.squaredNorm());
  };
  EXPECT_LT((velocity(1e-100) - velocity(1.0)).norm(), 1e-15);
  EXPECT_GT((velocity(1e-100) - p).norm(), 0.5);
  EXPECT_TRUE(velocity(0.0).array().isNaN().all());
}

}  // namespace
}  // namespace fde::bench
