// SPDX-License-Identifier: MIT
// Constraints that lose their rank: the motion is not determined there, and no formulation steps over it.

#include <gtest/gtest.h>

#include <numbers>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct LostRank {
  std::vector<std::string> constraints;
  std::vector<double> velocity;
  double time;  // NaN: never
};

// x, y and z of unit mass from (0.2, 0, 0.1).
Scene scene_with(const LostRank& of, const std::string& formulation) {
  Scene scene =
      scene_of_mechanical_file(mechanical_file_of({.coordinates = {"x", "y", "z"},
                                                   .position = {0.2, 0.0, 0.1},
                                                   .velocity = of.velocity,
                                                   .lagrangian = "(D(x,1)^2 + D(y,1)^2 + D(z,1)^2)/2",
                                                   .constraints = of.constraints}),
                               {{"formulation", formulation}});
  scene.problem.end = 3.0;
  return scene;
}

// Runs with all schemes over grids that accept it, in all formulations.
void expect_end_at(const LostRank& of) {
  for (const auto* formulation : {"integrated", "acceleration", "stabilised", "multiplier"}) {
    const Scene scene = scene_with(of, formulation);
    ASSERT_EQ(scene.ill_posed_reason, "") << formulation;
    for (const auto* scheme : row_schemes()) {
      for (const int steps : {37, 300, 1000}) {
        const Grid grid{3.0, steps};
        if (unsupported_reason(*scheme, scene.problem, grid)) continue;
        const auto path = scheme->solve(scene.problem, grid, {});
        EXPECT_EQ(path.status, SolveStatus::left_domain) << scheme->id << ' ' << formulation << ' ' << steps;
        EXPECT_NEAR(path.failure_time.value_or(0.0), of.time + 0.5 * grid.step(), 0.51 * grid.step())
            << scheme->id << ' ' << formulation << ' ' << steps;
      }
    }
  }
}

constexpr double quarter = 0.5 * std::numbers::pi;

TEST(ConstraintRank, IsLostWhereACoefficientVanishesAtATime) {
  expect_end_at({{"cos(t)*D(x,1) - 0.5"}, {0.5, 0.3, 0.1}, quarter});
  expect_end_at({{"cos(t)*(D(x,1) + 2*D(y,1)) - 0.5"}, {0.1, 0.2, 0.1}, quarter});
}

TEST(ConstraintRank, IsLostWhereACoefficientVanishesAtAState) {
  // y = 0.3 t
  expect_end_at({{"(0.4512 - y)*D(x,1) - 0.4512*0.5"}, {0.5, 0.3, 0.1}, 1.504});
}

TEST(ConstraintRank, IsLostWhereTwoConstraintsBecomeDependent) {
  expect_end_at({{"D(x,1) + D(y,1) - 0.8", "D(x,1) + (1 - cos(t))*D(y,1) - 0.5"}, {0.5, 0.3, 0.1}, quarter});
}

// The direction turns by much in a step, and by all angles in the run, but its length is 1.
TEST(ConstraintRank, IsKeptWhereTheDirectionTurns) {
  const LostRank turning{{"cos(2*t)*D(x,1) + sin(2*t)*D(y,1)"}, {0.0, 0.3, 0.1}, 0.0};
  for (const auto* formulation : {"integrated", "acceleration", "multiplier"}) {
    const Scene scene = scene_with(turning, formulation);
    for (const int steps : {4, 5, 100}) {
      EXPECT_EQ(solve("product_trapezoidal", scene.problem, steps).status, SolveStatus::finished)
          << formulation << steps;
    }
  }
}

}  // namespace
}  // namespace fde::bench
