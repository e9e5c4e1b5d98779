// SPDX-License-Identifier: MIT
// Initial velocities that are projected onto the constraints.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"

namespace fde::bench {
namespace {

// Masses 1 and 3 under x' + 2 y' + w = 0, w = 0 at t = 0.
WrittenSystem two_masses(double vx, double vy) {
  return {.coordinates = {"x", "y"},
          .position = {0.0, 0.0},
          .velocity = {vx, vy},
          .lagrangian = "(D(x,1)^2 + 3*D(y,1)^2)/2 - x^2",
          .constraints = {"D(x,1) + 2*D(y,1) + 0.3*D(x,0.4)"}};
}

Vec initial_columns(const Scene& scene) {
  return columns_at(scene.outputs, 0.0, taylor_part(scene.problem, 0.0));
}

// v - M^-1 a^T (a M^-1 a^T)^-1 a.v with a = (1, 2), M = diag(1, 3): a M^-1 a^T = 7/3.
TEST(ProjectedStart, IsNearestInTheMetricOfTheLagrangian) {
  const double vx = 0.333333, vy = -0.166667, defect = (vx + 2.0 * vy) * 3.0 / 7.0;
  const auto text = mechanical_file_of(two_masses(vx, vy));
  EXPECT_THROW(scene_of_mechanical_file(text), std::invalid_argument);
  for (const std::string formulation : {"integrated", "acceleration", "stabilised", "multiplier"}) {
    const Vec columns = initial_columns(
        scene_of_mechanical_file(text, {{"initial_velocity", "projected"}, {"formulation", formulation}}));
    EXPECT_NEAR(columns[2], vx - defect, 1e-16) << formulation;
    EXPECT_NEAR(columns[3], vy - 2.0 / 3.0 * defect, 1e-16) << formulation;
  }
}

// The direction of a pendulum's constraint x x' + y y' = 0 at (0.6, -0.8) is the position itself.
TEST(ProjectedStart, HoldsNonlinearConstraintsAndVakonomicOnes) {
  WrittenSystem pendulum{.coordinates = {"x", "y"},
                         .position = {0.6, -0.8},
                         .velocity = {0.8001, 0.6},
                         .lagrangian = "(D(x,1)^2 + D(y,1)^2)/2 - y",
                         .constraints = {"x*D(x,1) + y*D(y,1)"}};
  for (const std::string principle : {"", "principle = \"vakonomic\"\n"}) {
    const Vec columns = initial_columns(scene_of_mechanical_file(
        mechanical_file_of(pendulum, principle + "initial_velocity = \"projected\"\n")));
    EXPECT_NEAR(columns[2], 0.8001 - 0.6 * 0.6e-4, 1e-15) << principle;
    EXPECT_NEAR(columns[3], 0.6 + 0.8 * 0.6e-4, 1e-15) << principle;
  }
  pendulum.constraints = {"D(x,1)^2 + D(y,1)^2 - 1"};
  const Vec columns = initial_columns(
      scene_of_mechanical_file(mechanical_file_of(pendulum), {{"initial_velocity", "projected"}}));
  EXPECT_NEAR(std::hypot(columns[2], columns[3]), 1.0, 1e-15);
  EXPECT_NEAR(columns[2] / columns[3], 0.8001 / 0.6, 1e-15);
}

// A velocity that keeps the constraint of order 1, w = v, needs no change: 1.3 x' + 2 y' = 0.
TEST(ProjectedStart, LeavesAVelocityThatKeepsTheConstraint) {
  auto system = two_masses(1.0, -0.65);
  system.constraints = {"D(x,1) + 2*D(y,1) + 0.3*D(x,alpha)"};
  const Vec columns = initial_columns(scene_of_mechanical_file(
      mechanical_file_of(system) + "[parameters]\nalpha = 1\n", {{"initial_velocity", "projected"}}));
  EXPECT_NEAR(columns[2], 1.0, 1e-15);
  EXPECT_NEAR(columns[3], -0.65, 1e-15);
}

}  // namespace
}  // namespace fde::bench
