// SPDX-License-Identifier: MIT
// A blade on a sphere: a curved metric and a nonholonomic constraint.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Point = Eigen::Vector3d;

Point outwards(In c) {
  return {std::sin(c[0]) * std::cos(c[1]), std::sin(c[0]) * std::sin(c[1]), std::cos(c[0])};
}

// The direction of the blade, cos(psi) e_theta + sin(psi) e_phi.
Point along(In c) {
  const Point south(std::cos(c[0]) * std::cos(c[1]), std::cos(c[0]) * std::sin(c[1]), -std::sin(c[0]));
  const Point east(-std::sin(c[1]), std::cos(c[1]), 0.0);
  return std::cos(c[2]) * south + std::sin(c[2]) * east;
}

double spin(In c) { return c[5] + std::cos(c[0]) * c[4]; }

// Position and blade rotate together about one axis, V (across) + spin (outwards).
TEST(BladeOnSphere, WithoutGravityDrawsACircle) {
  const Scene scene = scene_of("blade_on_sphere", {{"gravity", 0.0}});
  const reference::Reference reference = reference_of(scene);
  const Vec start = reference.at(0.0).value;
  const Point axis = 0.6 * outwards(start).cross(along(start)) + outwards(start);
  for (const double t : {0.5, 3.0, 10.0}) {
    const Vec now = reference.at(t).value;
    const Eigen::AngleAxisd turn(axis.norm() * t, axis.normalized());
    EXPECT_LT((outwards(now) - turn * outwards(start)).norm(), 1e-12) << t;
    EXPECT_LT((along(now) - turn * along(start)).norm(), 1e-12) << t;
  }
}

// theta' = V cos psi, sin(theta) phi' = V sin psi, V' = gravity sin(theta) cos(psi), psi' + phi' cos theta =
// 1, solved by Taylor's method in 20 digits: without multiplier, metric or projection.
TEST(BladeOnSphere, IsTheMotionOfItsReducedEquations) {
  const reference::Reference reference = reference_of(scene_of("blade_on_sphere"));
  const Vec three = reference.at(3.0).value, ten = reference.at(10.0).value;
  EXPECT_LT(
      (three.head<3>() - Point(0.82398924127608987935, 1.3450278016598434129, 3.3314532866150631141)).norm(),
      1e-12);
  EXPECT_LT(
      (ten.head<3>() - Point(0.58898027497650471855, 1.0549710654754943411, 11.53208059859933220636)).norm(),
      1e-11);
}

// In every formulation, at the rate of the scheme; the constraint in the formulations that satisfy it
// exactly.
TEST(BladeOnSphere, KeepsEnergyAndItsRateOfTurning) {
  for (const auto* form : {"integrated", "acceleration", "stabilised", "multiplier"}) {
    const Scene scene = scene_of("blade_on_sphere", {{"formulation", form}});
    const auto off = [&](int steps) {
      const auto path = solve("product_trapezoidal", scene.problem, steps);
      const Rows columns = columns_of(scene.outputs, path);
      double worst = 0.0;
      for (int n = 0; n <= steps; ++n) {
        worst = std::max(worst, std::abs(spin(columns.col(n)) - 1.0));
        worst = std::max(worst,
                         std::abs(scene.energy.value(columns.col(n)) - scene.energy.value(columns.col(0))));
        if (std::string_view(form) == "integrated" || std::string_view(form) == "multiplier") {
          EXPECT_LT(scene.constraint.drift(path.time(n), columns.col(n)), 1e-12) << form;
        }
      }
      return worst;
    };
    const double coarse = off(512), fine = off(2048);
    EXPECT_LT(fine, 1e-4) << form;
    EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 2.0, 0.2) << form;
  }
}

// a = (sin psi, -sin theta cos psi, 0) and a.curl a = sin(theta) != 0: no multiple of a is the gradient of a
// function (Frobenius).
TEST(BladeOnSphere, HasAConstraintThatCannotBeIntegrated) {
  const auto a = [](const Point& q) { return Point(std::sin(q[2]), -std::sin(q[0]) * std::cos(q[2]), 0.0); };
  const Point q(0.9, 0.2, 0.3);
  constexpr double h = 1e-5;
  Matrix slope(3, 3);
  for (Eigen::Index j = 0; j < 3; ++j)
    slope.col(j) = (a(q + h * Point::Unit(j)) - a(q - h * Point::Unit(j))) / (2.0 * h);
  const Point curl(slope(2, 1) - slope(1, 2), slope(0, 2) - slope(2, 0), slope(1, 0) - slope(0, 1));
  EXPECT_NEAR(std::abs(a(q).dot(curl)), std::sin(0.9), 1e-9);
  // The scene's constraint is a.v.
  const Scene scene = scene_of("blade_on_sphere");
  for (Eigen::Index j = 0; j < 3; ++j) {
    Vec columns(6), f(1);
    columns << q, Point::Unit(j);
    scene.constraint.value(0.0, columns, f);
    EXPECT_NEAR(f[0], a(q)[j], 1e-15);
  }
}

// From differences of the metric in 30 digits.
TEST(BladeOnSphere, HasTheGeometryOfItsMetric) {
  const Geometry at = scene_of("blade_on_sphere").geometry.at(Point(0.9, 0.0, 0.3), Point(0.4, -0.5, 0.7));
  EXPECT_NEAR(at.christoffel[0](1, 1), -0.2921542892634586, 1e-15);
  EXPECT_NEAR(at.christoffel[0](1, 2), 0.1566653819254967, 1e-15);
  EXPECT_NEAR(at.christoffel[1](0, 1), 0.6348409182738537, 1e-15);
  EXPECT_NEAR(at.christoffel[1](2, 0), -0.2553212426917791, 1e-15);
  EXPECT_NEAR(at.christoffel[2](1, 0), -0.7862868978788714, 1e-15);
  EXPECT_NEAR(at.christoffel[2](0, 2), 0.1587102295684634, 1e-15);
  EXPECT_NEAR(at.connection(1, 0), -0.4961453290211722, 1e-15);
  EXPECT_NEAR(at.connection(2, 2), 0.06348409182738537, 1e-15);
  EXPECT_LT((at.semispray - Point(-0.339369721589209, -0.3969162632169378, 0.4033924877098881)).norm(),
            1e-14);
  EXPECT_NEAR(at.multipliers[0], -0.1085044126927892, 1e-15);
  EXPECT_LT(
      (at.constrained_semispray - Point(-0.3073044751265687, -0.5292469969151589, 0.4856505908852731)).norm(),
      1e-14);
  EXPECT_NEAR(at.constrained_connection(1, 0), -0.63218269379286, 1e-12);
  EXPECT_NEAR(at.constrained_connection(0, 2), -0.054715591033655, 1e-12);
}

}  // namespace
}  // namespace fde::bench
