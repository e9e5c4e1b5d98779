// SPDX-License-Identifier: MIT
// Forces with derivatives of orders above 1 beside constraints with memory: the row of such a force has the
// acceleration as its right-hand side, which contains w' of the constraints.

#include <gtest/gtest.h>

#include <stdexcept>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// Two masses with f = y' + x'/2 - cos(x) D^0.4 x - (y'(0) + x'(0)/2) and the force -D^1.7 y along y.
std::string masses_with_velocity(double velocity) {
  return mechanical_file_of(
      {.coordinates = {"x", "y"},
       .position = {1.0, 0.0},
       .velocity = {velocity, 0.0},
       .lagrangian = "D(x,1)^2 + D(y,1)^2 - x^2",
       .constraints = {fmt::format("D(y,1) + D(x,1)/2 - cos(x)*D(x,0.4) - {}", velocity / 2.0)},
       .forces = {"0", "-D(y,1.7)"}});
}

Vec state_at_end(const std::string& file, const std::string& formulation) {
  const Scene scene = scene_of_mechanical_file(file, {{"formulation", formulation}});
  const auto path = find_scheme("spectral_collocation")
                        ->solve(scene.problem, Tolerance{.rtol = 1e-9, .atol = 1e-9},
                                {.output_times = {scene.problem.end}});
  return columns_of(scene.outputs, path).rightCols(1).topRows(4);
}

std::string refusal(const std::string& file, const std::string& formulation) {
  return message_of<std::invalid_argument>([&] {
    scene_of_mechanical_file(file, {{"formulation", formulation}});
  });
}

// With v(0) = 0 along the memory term v' is bounded, and both forms exist.
TEST(ForcesAboveOrderOne, HaveOneMotionInTheAccelerationAndTheMultiplierForm) {
  const auto file = masses_with_velocity(0.0);
  const Vec found = state_at_end(file, "acceleration");
  EXPECT_LT((found - state_at_end(file, "multiplier")).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_GT((found - Vec::Unit(4, 0)).cwiseAbs().minCoeff(), 1e-2);  // the masses have moved
}

TEST(ForcesAboveOrderOne, HaveNoIntegratedForm) {
  EXPECT_EQ(
      refusal(masses_with_velocity(0.0), "integrated"),
      "formulation = integrated: must be multiplier, acceleration or stabilised where a force contains a "
      "derivative of order 1.7 beside one of an order below 1 in a constraint");
  const Scene by_default = scene_of_mechanical_file(masses_with_velocity(0.0));
  EXPECT_GT(by_default.smoothness.unmeasured.size(), 0U);  // the rows D^order v of the acceleration form
}

// The order may be a parameter, whose value decides.
TEST(ForcesAboveOrderOne, AreToldByTheValuesOfParameters) {
  std::string file = masses_with_velocity(0.0);
  file.replace(file.find("1.7"), 3, "p");
  const auto with = [&](const std::string& at_default) {
    return std::string(file).insert(file.find('['), "[parameters]\np = " + at_default + "\n");
  };
  const auto accepts = [](const std::string& text, double p) {
    return message_of<std::invalid_argument>([&] {
             scene_of_mechanical_file(text, {{"p", p}, {"formulation", "integrated"}});
           }) == "accepted";
  };
  for (const char* at_default : {"0.6", "1.6"}) {
    EXPECT_TRUE(accepts(with(at_default), 0.6)) << at_default;
    EXPECT_FALSE(accepts(with(at_default), 1.6)) << at_default;
  }
}

// With v(0) != 0 v' starts like t^-0.4, which is no right-hand side of a row.
TEST(ForcesAboveOrderOne, HaveOnlyTheMultiplierFormWhereTheAccelerationIsUnbounded) {
  const auto file = masses_with_velocity(0.5);
  EXPECT_EQ(
      refusal(file, "acceleration"),
      "formulation = acceleration: must be multiplier: v' is unbounded at t = 0, and a force contains a "
      "derivative of order 1.7");
  EXPECT_EQ(refusal(file, "multiplier"), "accepted");
}

}  // namespace
}  // namespace fde::bench
