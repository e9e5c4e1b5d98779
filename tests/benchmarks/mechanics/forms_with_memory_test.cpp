// SPDX-License-Identifier: MIT
// The statements of docs/mechanics.md that compare the formulations with memory.

#include <gtest/gtest.h>

#include <algorithm>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// The drift at every step.
std::vector<double> drifts(const std::string& formulation) {
  const Scene scene = scene_of("fractional_constraint_2d", {{"alpha", 0.3}, {"formulation", formulation}});
  const auto path = solve("product_trapezoidal", scene.problem, 4096);
  const Rows columns = columns_of(scene.outputs, path);
  std::vector<double> found;
  for (Eigen::Index c = 0; c < columns.cols(); ++c)
    found.push_back(scene.constraint.drift(path.time(c), columns.col(c)));
  return found;
}

TEST(FormsWithMemory, StabilisingLowersTheDriftAtTheEndButNotTheLargest) {
  const auto plain = drifts("acceleration"), stabilised = drifts("stabilised");
  EXPECT_NEAR(std::ranges::max(stabilised) / std::ranges::max(plain), 1.0, 0.05);
  EXPECT_GT(plain.back(), 1e-6);
  EXPECT_LT(stabilised.back(), 1e-8);
}

TEST(FormsWithMemory, TheMultiplierFormOnAGradedGridIsTheBetterOne) {
  const auto error = [](const std::string& formulation) {
    Scene scene = scene_of("fractional_constraint_nonlinear", {{"formulation", formulation}});
    scene.problem.end = 1.0;
    const auto path = solve("product_trapezoidal", scene.problem, Grid{1.0, 4096, 2.0});
    const Vec end = columns_of(scene.outputs, path).rightCols(1);
    return (end - reference_of(scene).at(1.0).value).cwiseAbs().maxCoeff();
  };
  const double multiplier = error("multiplier");
  EXPECT_LT(multiplier, 2.5e-8);
  EXPECT_GT(error("acceleration"), 2.0 * multiplier);
}

}  // namespace
}  // namespace fde::bench
