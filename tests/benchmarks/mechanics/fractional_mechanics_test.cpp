// SPDX-License-Identifier: MIT
// Scenes of mechanics with memory: formulations, limits, and refusals.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Values = ParameterValues;

Values with(Values values, const Values& more) {
  for (const auto& [name, value] : more) values[name] = value;
  return values;
}

Scene knife_edge(const Values& values) { return scene_of("fractional_knife_edge", values); }

// All columns at all steps.
Rows run(const Scene& scene, int steps, std::string_view scheme = "product_trapezoidal") {
  const auto path = solve(scheme, scene.problem, steps);
  EXPECT_EQ(path.status, SolveStatus::finished);
  return columns_of(scene.outputs, path);
}

double largest(const Rows& rows) { return rows.cwiseAbs().maxCoeff(); }

// x = g sin theta/(2 omega^2) sin^2(omega t), y = g sin theta/(2 omega^2) (omega t - sin(2 omega t)/2).
TEST(FractionalKnifeEdge, WithoutMemoryIsTheKnifeEdge) {
  const Values values{{"b", 0.0}, {"speed", 0.0}, {"g", 2.0}, {"omega", 1.5}};
  const reference::Reference reference = reference_of(knife_edge(values));
  const double size = 2.0 * std::sin(0.5) / (2.0 * 1.5 * 1.5);
  for (const double t : {0.4, 3.0, 10.0}) {
    const auto [value, bound] = reference.at(t);
    EXPECT_NEAR(value[0], size * std::pow(std::sin(1.5 * t), 2), bound[0] + 1e-14) << t;
    EXPECT_NEAR(value[1], size * (1.5 * t - 0.5 * std::sin(3.0 * t)), bound[1] + 1e-14) << t;
    EXPECT_NEAR(value[2], 1.5 * t, bound[2] + 1e-14) << t;
  }
}

// phi = k ln(tan(theta/2)/tan(theta(0)/2)) at constant speed.
TEST(FractionalKnifeEdge, OnTheSphereWithoutMemoryAndGravityIsTheLoxodrome) {
  const Scene scene = knife_edge({{"surface", "sphere"}, {"b", 0.0}, {"g", 0.0}});
  const double theta = 0.7 + 0.5 * 2.0 / std::hypot(1.0, 0.5);
  const double phi = 0.5 * std::log(std::tan(theta / 2.0) / std::tan(0.35));
  const auto error = [&](int steps) {
    const Vec end = run(scene, steps).rightCols(1);
    return std::hypot(end[0] - theta, end[1] - phi);
  };
  EXPECT_LT(error(2000), 1e-7);
  EXPECT_NEAR(error(1000) / error(2000), 4.0, 0.01);
}

class OnBothSurfaces : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, OnBothSurfaces, testing::Values("plane", "sphere"), text_of_param);

// The memory term is b times the constraint, so alpha = 1 gives (1 + b) times the constraint.
TEST_P(OnBothSurfaces, AlphaToOneIsTheMotionWithoutMemory) {
  const Values surface{{"surface", GetParam()}};
  const Rows whole = run(knife_edge(with(surface, {{"alpha", 1.0}})), 200);
  const Rows none = run(knife_edge(with(surface, {{"alpha", 1.0}, {"b", 0.0}})), 200);
  const Rows next = run(knife_edge(with(surface, {{"alpha", 1.0 - 0x1p-53}})), 200);
  EXPECT_LT(largest(whole - none), 1e-12);
  EXPECT_LT(largest((next - whole).rightCols(200)), 1e-12);  // D^alpha q is 0 at t = 0 for alpha < 1
}

TEST_P(OnBothSurfaces, MemoryOfNoWeightDoesNothing) {
  const Values surface{{"surface", GetParam()}, {"b", 0.0}};
  const Rows with_memory = run(knife_edge(surface), 200);
  const Rows none = run(knife_edge(with(surface, {{"alpha", 1.0}})), 200);
  const Eigen::Index moved = 2 * with_memory.rows() / 3;
  EXPECT_LT(largest((with_memory - none).topRows(moved)), 1e-13);
}

TEST_P(OnBothSurfaces, TheIntegratedFormKeepsTheConstraint) {
  const Scene scene = knife_edge({{"surface", GetParam()}});
  for (const auto* scheme : row_schemes()) {
    const Rows columns = run(scene, 100, scheme->id);
    for (int n = 0; n <= 100; ++n) {
      ASSERT_LT(scene.constraint.drift(scene.problem.end * n / 100, columns.col(n)), 1e-13)
          << scheme->id << ' ' << n;
    }
  }
}

TEST_P(OnBothSurfaces, AllFormsAreOneMotion) {
  const Vec reference = reference_of(knife_edge({{"surface", GetParam()}})).at(2.0).value;
  for (const auto* form : {"integrated", "acceleration", "stabilised", "multiplier"}) {
    Scene scene = knife_edge({{"surface", GetParam()}, {"formulation", form}});
    scene.problem.end = 2.0;
    const auto error = [&](int steps) { return largest(run(scene, steps).rightCols(1) - reference); };
    EXPECT_LT(error(1600), 5e-4) << form;
    EXPECT_LT(error(1600), 0.5 * error(800)) << form;
  }
}

Scene thermostat(const Values& values) { return scene_of("fractional_constraint_nonlinear", values); }

TEST(FractionalConstraintNonlinear, AllFormsAreOneMotion) {
  const Vec reference = reference_of(thermostat({})).at(2.0).value;
  for (const auto* form : {"acceleration", "stabilised", "multiplier"}) {
    Scene scene = thermostat({{"formulation", form}});
    scene.problem.end = 2.0;
    const auto error = [&](int steps) { return largest(run(scene, steps).rightCols(1) - reference); };
    EXPECT_LT(error(1600), 1e-3) << form;
    EXPECT_LT(error(1600), 0.55 * error(800)) << form;
  }
}

TEST(FractionalConstraintNonlinear, ItsReferenceIsOnTheConstraint) {
  const Scene scene = thermostat({});
  const reference::Reference reference = reference_of(scene);
  for (const double t : {1e-6, 0.1, 1.0, 10.0})
    EXPECT_LT(scene.constraint.drift(t, reference.at(t).value), 1e-12) << t;
}

// Without coupling |v| is constant for every alpha.
TEST(FractionalConstraintNonlinear, WithoutCouplingIsTheThermostat) {
  const Vec v = reference_of(thermostat({{"coupling", 0.0}})).at(3.0).value.segment(2, 2);
  EXPECT_NEAR(v.norm(), 1.0, 1e-13);
}

TEST(FractionalConstraintNonlinear, FromOneHalfOnTheMultiplierFits) {
  expect_message(
      [] {
        thermostat({{"alpha", 0.5}});
      },
      "formulation = acceleration: must be neither acceleration nor stabilised");
  const Scene scene = thermostat({{"alpha", 0.6}, {"formulation", "multiplier"}});
  const reference::Reference reference = reference_of(scene);
  for (const double t : {1e-6, 0.1, 1.0, 10.0})
    EXPECT_LT(scene.constraint.drift(t, reference.at(t).value), 1e-12) << t;
  const Rows columns = run(scene, 100);
  for (int n = 0; n <= 100; ++n) ASSERT_LT(scene.constraint.drift(0.1 * n, columns.col(n)), 1e-13) << n;
}

// With powers of t^(1 - alpha) = t^0.05 the reference would have to start below the smallest double: there is
// none. Measures that need no reference are still recorded.
TEST(FractionalConstraintNonlinear, NextToOneAnExaminationSaysThatNothingIsKnown) {
  const Scene scene = thermostat({{"alpha", 0.95}, {"formulation", "multiplier"}});
  MemoizedReference reference(scene);
  const auto run = examine({}, scene, reference, *find_scheme("product_trapezoidal"), {64});
  EXPECT_EQ(run.ending.kind, Verdict::no_reference);
  EXPECT_TRUE(run["rhs_calls"]);
  EXPECT_FALSE(run["error_end"]);
  EXPECT_FALSE(run["reference_bound"]);
}

}  // namespace
}  // namespace fde::bench
