// SPDX-License-Identifier: MIT
// The geometry of Niminet & Blanuta 2009, without the factor 1/2 of their (2.6) and (2.8).

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

const Vector2d on_sphere(0.7, 0.3), along_sphere(0.4, -0.9);

// The geometry of a scene at one state.
Geometry geometry_at(std::string_view scene, const Vec& q, const Vec& v, const ParameterValues& values = {}) {
  return scene_of(scene, values).geometry.at(q, v);
}

// The unit sphere without a constraint, with these forces on theta and phi.
WrittenSystem sphere_with(const std::vector<std::string>& forces, const Vector2d& q = on_sphere,
                          const Vector2d& v = along_sphere) {
  return {.coordinates = {"theta", "phi"},
          .position = {q[0], q[1]},
          .velocity = {v[0], v[1]},
          .lagrangian = "(D(theta,1)^2 + sin(theta)^2*D(phi,1)^2)/2",
          .constraints = {},
          .forces = forces};
}

// Gamma^theta_phi,phi = -sin cos, Gamma^phi_theta,phi = cot; the others are 0.
TEST(ChristoffelSymbols, OfTheSphere) {
  const double theta = 0.7;
  const auto symbols = geometry_at("loxodrome", Vector2d(theta, 1.1), along_sphere).christoffel;
  const Matrix2d of_theta{{0.0, 0.0}, {0.0, -std::sin(theta) * std::cos(theta)}};
  const Matrix2d of_phi{{0.0, 1.0 / std::tan(theta)}, {1.0 / std::tan(theta), 0.0}};
  EXPECT_LT((symbols[0] - of_theta).norm(), 1e-15);
  EXPECT_LT((symbols[1] - of_phi).norm(), 1e-15);
}

TEST(ChristoffelSymbols, AreZeroForAConstantMetric) {
  const Geometry particle = geometry_at("nonholonomic_particle", Vector3d(1, 2, 3), Vector3d(1, 1, 2));
  EXPECT_EQ(particle.metric, Matrix3d::Identity());
  const Geometry disc = geometry_at("rolling_disc", Eigen::Vector4d(1, 2, 3, 4), Eigen::Vector4d(1, 0, 1, 2),
                                    {{"R", 0.5}, {"m", 2.0}, {"I", 0.3}, {"J", 0.2}});
  EXPECT_EQ(disc.metric, Matrix(Eigen::Vector4d(2.0, 2.0, 0.2, 0.3).asDiagonal()));
  for (const auto& geometry : {particle, disc})
    for (const auto& symbols : geometry.christoffel) EXPECT_EQ(symbols.norm(), 0.0);
}

// The canonical metrical connection (2.9): symmetric, and dg_ij/dx^k = Gamma^m_ki g_mj + Gamma^m_kj g_im.
TEST(ChristoffelSymbols, MakeTheMetricParallel) {
  const Scene scene = scene_of("loxodrome");
  const Vector2d x(0.9, 0.4);
  const auto at = [&](const Vector2d& q) { return scene.geometry.at(q, along_sphere); };
  const Geometry here = at(x);
  constexpr double h = 1e-5;
  for (int k = 0; k < 2; ++k) {
    const Vector2d step = h * Vector2d::Unit(k);
    const Matrix2d slope = (at(x + step).metric - at(x - step).metric) / (2 * h);
    Matrix2d connected = Matrix2d::Zero();
    for (int m = 0; m < 2; ++m) {
      const Matrix2d symbols = here.christoffel[static_cast<std::size_t>(m)];
      EXPECT_EQ(symbols, symbols.transpose());
      const Vector2d row = symbols.row(k), lower = here.metric.col(m);
      connected += row * lower.transpose() + lower * row.transpose();
    }
    EXPECT_LT((slope - connected).norm(), 1e-9) << "k = " << k;
  }
}

TEST(Semispray, IsHomogeneousWithoutForces) {
  const Vec one = geometry_at("loxodrome", on_sphere, along_sphere).constrained_semispray;
  for (const double factor : {-1.0, 2.0, 5.0}) {
    const Vec scaled = geometry_at("loxodrome", on_sphere, factor * along_sphere).constrained_semispray;
    EXPECT_LT((scaled - factor * factor * one).norm(), 1e-14);
  }
}

// Without constraint forces it is the geodesic spray: great circles, q'' = -2 G with y^i = x'^i. Tested for
// the meridian and the equator, with the constraint left out of the file and out of the geometry.
TEST(Semispray, WithoutMultipliersIsThatOfGeodesics) {
  const Scene free = scene_of_mechanical_file(mechanical_file_of(sphere_with({}))),
              bound = scene_of("loxodrome");
  const Vector2d equator(std::numbers::pi / 2, 0.0);
  for (const auto* scene : {&free, &bound}) {
    const auto spray = [&](const Vector2d& x, const Vector2d& y) {
      return scene->geometry.at(x, y).semispray;
    };
    EXPECT_EQ(spray(Vector2d(0.7, 0.0), Vector2d(1.3, 0.0)).norm(), 0.0);
    EXPECT_LT(spray(equator, Vector2d(0.0, 1.3)).norm(), 2e-16);
  }
  EXPECT_EQ(free.geometry.at(on_sphere, along_sphere).constrained_semispray.size(), 0);
}

// A motion without forces stays in the plane through the centre that it starts in, at a constant speed.
TEST(Semispray, OfGeodesicsHasGreatCirclesAsItsIntegralCurves) {
  const Scene scene = scene_of_mechanical_file(
      mechanical_file_of(sphere_with({}, Vector2d(std::numbers::pi / 2, 0.0), Vector2d(0.6, 0.8))));
  const auto error = [&](int steps) {
    const Vec end = solve("product_trapezoidal", scene.problem, steps).y.rightCols(1);
    const double theta = end[0], phi = end[1];
    const Vector3d place(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    const Vector3d start(1.0, 0.0, 0.0), direction(0.0, 0.8, -0.6);
    return (place - start * std::cos(1.0) - direction * std::sin(1.0)).norm();
  };
  EXPECT_LT(error(2000), 1e-6);
  EXPECT_NEAR(std::log2(error(500) / error(1000)), 2.0, 0.05);
}

// lambda = x' y' / (1 + y^2).
TEST(Semispray, MultipliersOfTheParticleAreQuadraticInTheVelocity) {
  const auto lambda = [](double dx, double dy) {
    return geometry_at("nonholonomic_particle", Vector3d(0.0, 0.5, 0.0), Vector3d(dx, dy, 0.5 * dx))
        .multipliers[0];
  };
  EXPECT_NEAR(lambda(1.0, 1.0), 0.8, 1e-15);
  EXPECT_NEAR(lambda(2.0, 1.0), 1.6, 1e-15);
}

// Theorem 2.3: x' = y, y' = -2 G* from the initial state of a scene reproduces its closed form.
void expect_evolution(const Scene& scene) {
  const auto n = scene.geometry.position.size();
  Problem problem{.rhs =
                      [&](double, In state, Out f) {
                        f.head(n) = state.tail(n);
                        f.tail(n) = -scene.geometry.at(state.head(n), state.tail(n)).constrained_semispray;
                      },
                  .end = 2.0};
  for (const double value : scene.reference.at(0.0).value) problem.components.push_back({1.0, {value}});
  std::vector<double> errors;
  for (const int steps : {500, 1000, 2000}) {
    const Vec end = solve("product_trapezoidal", problem, steps).y.rightCols(1);
    errors.push_back((end - scene.reference.at(2.0).value).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(errors[2], 1e-5);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.05);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.05);
}

TEST(Semispray, HasTheEvolutionCurvesAsItsIntegralCurves) {
  expect_evolution(scene_of("nonholonomic_particle"));
  expect_evolution(scene_of("loxodrome", {{"speed", 0.5}}));
  expect_evolution(scene_of("knife_edge"));
  expect_evolution(scene_of("rolling_disc", {{"pull", 0.6}}));
}

// Theorem 2.4: N* = N for any multipliers that are functions of position only, lambda = sin(theta) cos(phi)
// with a = (-2, sin(theta)). Their forces change G* but not its derivative.
TEST(NonlinearConnection, IsRiemannsForMultipliersOfThePlace) {
  const std::string text =
      mechanical_file_of(sphere_with({"-2*sin(theta)*cos(phi)", "sin(theta)^2*cos(phi)"}));
  const DynamicsOfFile motion(text);
  const auto by_velocity = motion.algebra.jacobian(motion.dynamics.free_acceleration(), motion.system.v());
  const Matrix connection = -0.5 * motion.values(by_velocity, 0.0, {on_sphere, along_sphere});
  const Geometry geometry = scene_of_mechanical_file(text).geometry.at(on_sphere, along_sphere);
  EXPECT_LT((connection - geometry.connection).norm(), 1e-15);
  const Vector2d expected = Vector2d(2.0 * std::sin(0.7), -1.0) * std::cos(0.3);
  const Vec free = geometry_at("loxodrome", on_sphere, along_sphere).semispray;
  EXPECT_LT((geometry.semispray - free - expected).norm(), 1e-15);
}

// It does not hold for the multipliers that enforce the constraint: G* contains -lambda a / 2, lambda = x'
// y'/(1 + y^2), a = (-y, 0, 1), and N = 0.
TEST(NonlinearConnection, IsAnotherForMultipliersThatKeepTheConstraint) {
  const Geometry particle =
      geometry_at("nonholonomic_particle", Vector3d(0.0, 0.5, 0.0), Vector3d(2.0, 1.0, 1.0));
  const Vector3d slope = Vector3d(1.0, 2.0, 0.0) / 1.25;  // d lambda / d(x', y', z')
  const Matrix3d expected = -0.5 * Vector3d(-0.5, 0.0, 1.0) * slope.transpose();
  EXPECT_EQ(particle.connection.norm(), 0.0);
  EXPECT_LT((particle.constrained_connection - expected).norm(), 1e-15);
  const Geometry sphere = geometry_at("loxodrome", on_sphere, along_sphere);
  EXPECT_GT((sphere.constrained_connection - sphere.connection).norm(), 0.1);
}

// G* is homogeneous of degree 2 without forces, so N* y = 2 G*.
TEST(NonlinearConnection, TimesTheVelocityIsTheSemispray) {
  const Geometry sphere = geometry_at("loxodrome", on_sphere, along_sphere);
  EXPECT_LT((sphere.constrained_connection * along_sphere - sphere.constrained_semispray).norm(), 1e-14);
  EXPECT_LT((sphere.connection * along_sphere - sphere.semispray).norm(), 1e-14);
}

}  // namespace
}  // namespace fde::bench
