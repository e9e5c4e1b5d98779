// SPDX-License-Identifier: MIT
// The ensembles of Tarasov & Zaslavsky, section 5: where e^(-E/T) is a stationary density, and that long
// motions have its averages.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fdebench/schemes/problem/problem.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using State = Eigen::Matrix<double, 6, 1>;  // q, v

Scene harmonic(std::string_view id, ParameterValues values) {
  values["c"] = 0.0;
  values["formulation"] = "stabilised";
  values["kappa"] = 5.0;
  return scene_of(id, values);
}

// The power of friction and reaction over the divergence of the whole flow.
double power_over_divergence(const Scene& scene, const State& at) {
  return scene.energy.power(0.0, at) / jacobian_at(scene.problem, 0.0, at).trace();
}

// A state of the chain whose first two masses have v1^2 + v2^2 = square.
State random_state(std::mt19937& random, double square) {
  std::normal_distribution<double> normal;
  State at;
  for (double& number : at) number = normal(random);
  at.segment<2>(3) *= std::sqrt(square) / at.segment<2>(3).norm();
  return at;
}

// 0.6^2 + 0.4^2 = 0.52 at the start.
TEST(Ensembles, PowerIsTheTemperatureTimesTheDivergence) {
  std::mt19937 random(1);
  for (const auto* id : {"canonical_ensemble", "isobaric_ensemble"}) {
    const Scene scene = scene_of(id);
    for (int i = 0; i < 100; ++i)
      EXPECT_NEAR(power_over_divergence(scene, random_state(random, 0.52)), 0.52, 1e-12) << id;
  }
}

// On a sphere of three dimensions the temperature is r^2/2, which is 3/2 times the temperature r^2/3 of the
// friction.
TEST(Ensembles, ThreeEqualFrictionsHaveTheTemperatureOfTwoDegreesOfFreedom) {
  std::mt19937 random(2);
  const Scene scene = scene_of("canonical_ensemble", {{"gamma1", 0.7}, {"gamma2", 0.7}, {"gamma3", 0.7}});
  for (int i = 0; i < 100; ++i) {
    State at = random_state(random, 1.0);
    at.tail<3>() *= std::sqrt(0.61) / at.tail<3>().norm();
    EXPECT_NEAR(power_over_divergence(scene, at), 0.305, 1e-12);
  }
}

// An ellipsoid that is no sphere has no T with n.v = T times its curvature: with frictions g and the axis i
// through it the quotient is (s/g_i) / (the sum of the other frictions over g_i), s = the sum of g_j v_j^2.
TEST(Ensembles, UnequalFrictionsHaveNoTemperature) {
  const Scene scene = scene_of("canonical_ensemble", {{"gamma1", 0.2}, {"gamma2", 0.5}, {"gamma3", 1.0}});
  const Eigen::Vector3d friction(0.2, 0.5, 1.0), start(0.6, -0.4, 0.3);
  const double s = friction.dot(start.cwiseAbs2());
  for (int i = 0; i < 3; ++i) {
    State at;
    at << 0.5, 0.2, -0.3, std::sqrt(s / friction[i]) * Eigen::Vector3d::Unit(i);
    EXPECT_NEAR(power_over_divergence(scene, at), s / (friction.sum() - friction[i]), 1e-12) << i;
  }
}

// Means of q1^2, q2^2, q3^2, q3, v3^2, v3^4 over a long motion by the classical method of Runge and Kutta.
// The constraint is kept by the stabilised form.
Eigen::Matrix<double, 6, 1> averages(const Scene& scene) {
  constexpr double h = 0.05;
  constexpr int steps = 400'000;
  Vec y(6), k(6), slope(6);
  for (int i = 0; i < 6; ++i) y[i] = scene.problem.components[static_cast<std::size_t>(i)].initial[0];
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  for (int n = 0; n < steps; ++n) {
    slope.setZero();
    k.setZero();
    for (const double weight : {0.0, 0.5, 0.5, 1.0}) {
      const Vec stage = y + h * weight * k;
      scene.problem.rhs(0.0, stage, k);
      slope += (weight == 0.5 ? 2.0 : 1.0) / 6.0 * k;
    }
    y += h * slope;
    const double square = y[5] * y[5];
    sum += (State() << y.head<3>().cwiseAbs2(), y[2], square, square * square).finished();
  }
  return sum / steps;
}

// Harmonic springs: the positions have the covariance T K^-1, K = [2 -1 0; -1 2 -1; 0 -1 2], and v3 is
// Gaussian.
TEST(Ensembles, ALongMotionHasTheCanonicalAverages) {
  const double temperature = 0.52;
  const auto mean = averages(harmonic("canonical_ensemble", {}));
  EXPECT_NEAR(mean[0] / temperature, 0.75, 0.08);
  EXPECT_NEAR(mean[1] / temperature, 1.0, 0.1);
  EXPECT_NEAR(mean[2] / temperature, 0.75, 0.08);
  EXPECT_NEAR(mean[4] / temperature, 1.0, 0.16);
  EXPECT_NEAR(mean[5] / (3 * temperature * temperature), 1.0, 0.3);
}

// Under a pressure p each spring has the mean length -p and the variance T, independently of the others.
TEST(Ensembles, ALongMotionHasTheIsobaricAverages) {
  const double temperature = 0.52, pressure = 0.5;
  const auto mean = averages(harmonic("isobaric_ensemble", {{"pressure", pressure}}));
  EXPECT_NEAR(mean[3], -3 * pressure, 0.08);
  EXPECT_NEAR(mean[0] - pressure * pressure, temperature, 0.06);
  EXPECT_NEAR(mean[2] - mean[3] * mean[3], 3 * temperature, 0.3);
  EXPECT_NEAR(mean[4] / temperature, 1.0, 0.16);
}

}  // namespace
}  // namespace fde::bench
