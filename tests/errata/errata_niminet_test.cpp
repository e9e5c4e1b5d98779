// SPDX-License-Identifier: MIT
// Niminet & Blanuta 2009, as printed and corrected, for the particle z' = y x' (mass 1, flat metric).

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/reference/linear/linear_system.hpp"

namespace fde::bench {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

// The constraint a.v = 0 of the particle at (x, y, z), and d/dt a.v without the acceleration.
Vector3d constraint_at(const Vector3d& q) { return {-q[1], 0.0, 1.0}; }

// The multiplier that keeps a.v = 0: a.(lambda a) - x' y' = 0.
double multiplier(const Vector3d& q, const Vector3d& v) {
  return v[0] * v[1] / constraint_at(q).squaredNorm();
}

// Free fall x'' = factor * F from rest, F = -g. The 1/2 of eq. 2.6 belongs to L = g_ij y^i y^j of 1.2, which
// is 2 T: a normalisation, not a misprint. With the kinetic energy T of mechanics it would halve the forces.
TEST(NiminetNormalisation, TheHalfOfEquation26BelongsToTwiceTheKineticEnergy) {
  const double g = 9.81, t = 2.0;
  const auto falls = [&](double factor) -> Vec {
    const Matrix flow = (Matrix(2, 2) << 0.0, 1.0, 0.0, 0.0).finished();
    return reference::linear_reference(reference::LinearSystem{.orders = {1.0, 1.0},
                                                               .initial = {{0.0}, {0.0}},
                                                               .matrix = flow,
                                                               .loads = {{}, {{-factor * g}}}})
        .at(t)
        .value;
  };
  const auto energy = [&](const Vec& state) { return 0.5 * state[1] * state[1] + g * state[0]; };
  EXPECT_NEAR(falls(1.0)[0], -0.5 * g * t * t, 1e-13);
  EXPECT_NEAR(energy(falls(1.0)), 0.0, 1e-12);
  EXPECT_NEAR(falls(0.5)[0], -0.25 * g * t * t, 1e-13);
  EXPECT_NEAR(energy(falls(0.5)), -g * g * t * t / 8.0, 1e-12);  // not conserved
}

// The force of a multiplier lambda(q) = x + 2z in the Euler-Lagrange equations, in both forms of 2.4: with
// A = lambda a it is (dA_j/dq_i - dA_i/dq_j) v_j and does no work.
TEST(ErrataNiminet, Equation24HasWrongIndicesInItsSecondForm) {
  const Vector3d q(0.3, 0.5, -0.2), v(1.0, 1.0, 0.5), a = constraint_at(q), slope(1.0, 0.0, 2.0);
  const double lambda = q[0] + 2.0 * q[2];
  Matrix3d by_q = Matrix3d::Zero();  // (i, j): d a_i / d q_j
  by_q(0, 1) = -1.0;
  // d lambda/dq_i (a.v) + lambda d(a.v)/dq_i - d/dt (lambda a_i)
  const Vector3d first =
      slope * a.dot(v) + lambda * (by_q.transpose() * v) - slope.dot(v) * a - lambda * (by_q * v);
  const Matrix3d second = slope * a.transpose() - a * slope.transpose() + lambda * (by_q.transpose() - by_q);
  EXPECT_LT((second * v - first).norm(), 1e-15);
  EXPECT_NEAR(v.dot(first), 0.0, 1e-15);
  // As printed every a has the index i.
  Matrix3d printed;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      printed(i, j) = slope[i] * a[i] - slope[j] * a[i] + lambda * (by_q(i, i) - by_q(i, j));
    }
  }
  EXPECT_GT((printed * v - first).norm(), 1.0);
  EXPECT_GT(std::abs(v.dot(printed * v)), 1.0);
}

// The paper derives 2.4 (conditional extremum) and 2.6 (d'Alembert) without stating their difference. The
// motion under d'Alembert's principle, y = y0 + t, x' = c / sqrt(1 + y^2), z' = y x', solves 2.6. In 2.4 the
// equation of y requires lambda x' = 0, and the equation of x then a constant x'.
TEST(NiminetNormalisation, Equation24IsNotEquation26) {
  const double c = 1.5, y = 0.7, root = std::sqrt(1.0 + y * y), dx = c / root;
  const Vector3d q(0.0, y, 0.0), v(dx, 1.0, y * dx);
  const Vector3d acceleration(-c * y / (root * root * root), 0.0, c / (root * root * root));
  EXPECT_NEAR(constraint_at(q).dot(v), 0.0, 1e-15);
  EXPECT_LT((acceleration - multiplier(q, v) * constraint_at(q)).norm(), 1e-15);
  // 2.4: (x' - lambda y)' = 0, y'' = -lambda x', (z' + lambda)' = 0.
  const double lambda = -acceleration[1] / dx;
  EXPECT_EQ(lambda, 0.0);
  EXPECT_GT(std::abs(acceleration[0] - lambda * v[1]), 0.5);
}

// The multiplier of the constraint is x' y' / (1 + y^2), not a function of the position.
TEST(ErrataNiminet, MultiplierDependsOnTheVelocity) {
  const Vector3d q(0.0, 0.5, 0.0);
  EXPECT_NEAR(multiplier(q, {1.0, 1.0, 0.5}), 0.8, 1e-15);
  EXPECT_NEAR(multiplier(q, {2.0, 1.0, 1.0}), 1.6, 1e-15);
}

// N_j^i = dG^i/dv^j with 2 G = -lambda a in a flat metric, where the connection of the space is 0.
TEST(ErrataNiminet, Theorem24FailsForTheMultiplierOfTheConstraint) {
  const Vector3d q(0.0, 0.5, 0.0), v(1.0, 1.0, 0.5);
  const auto connection = [&](const auto& lambda) {
    Matrix3d n;
    const double h = 1e-3;  // lambda is quadratic: central differences are exact
    for (int j = 0; j < 3; ++j) {
      const Vector3d step = h * Vector3d::Unit(j);
      n.col(j) = -0.5 * (lambda(v + step) - lambda(v - step)) / (2.0 * h) * constraint_at(q);
    }
    return n;
  };
  const Matrix3d enforcing = connection([&](const Vector3d& at) { return multiplier(q, at); });
  EXPECT_NEAR(enforcing(0, 0), 0.2, 1e-12);   // -1/2 * 0.8 * (-0.5)
  EXPECT_NEAR(enforcing(2, 1), -0.4, 1e-12);  // -1/2 * 0.8 * 1
  // The case of the theorem: a multiplier given as a function of the position.
  EXPECT_EQ(connection([&](const Vector3d&) { return q[0] + 2.0 * q[2]; }).norm(), 0.0);
}

// The straight line x = 1, y = t in polar coordinates: q'' = -2 G with 2 G^i = Gamma^i_jk v^j v^k.
TEST(ErrataNiminet, Equation25LosesTheMinus) {
  const double t = 0.8, r = std::hypot(1.0, t), dr = t / r, dphi = 1.0 / (r * r);
  const double ddr = 1.0 / r - t * t / (r * r * r), ddphi = -2.0 * dr / (r * r * r);
  const Eigen::Vector2d twice_g(-r * dphi * dphi, 2.0 / r * dr * dphi), acceleration(ddr, ddphi);
  EXPECT_LT((acceleration + twice_g).norm(), 1e-15);
  EXPECT_GT((acceleration - twice_g).norm(), 0.5);
}

}  // namespace
}  // namespace fde::bench
