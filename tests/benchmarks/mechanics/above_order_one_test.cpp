// SPDX-License-Identifier: MIT
// 1 < alpha < 2 in the plane and on the line: every C0 is admissible, and the discretisations of the
// formulations differ.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

ParameterValues plane(double alpha, const ParameterValue& constant, const std::string& formulation) {
  return {{"alpha", alpha},
          {"a1", 1.0},
          {"a2", 0.5},
          {"b1", 0.8},
          {"b2", 0.3},
          {"C0", constant},
          {"formulation", formulation}};
}

// q1, q2, lambda at t = 1, from Laplace transforms inverted in 30 digits (Talbot contour, mpmath).
struct KnownStart {
  double alpha;
  ParameterValue constant;
  double q1, q2, lambda;
};
const std::array known{
    KnownStart{1.5, 0.0, 1.1656754129312, -0.00411994594170824, 0.9139166466279092},
    KnownStart{1.2, 0.0, 1.15534932079803, -0.0074892761163345, 0.92576384210619801},
    KnownStart{1.5, std::string("a1*v1+a2*v2"), 1.29199062340401, 0.0514508608173795, 1.0883401285245232},
};

TEST(AboveOrderOne, TheReferenceTakesEveryConstant) {
  for (const auto& [alpha, constant, q1, q2, lambda] : known) {
    const Scene scene = scene_of("fractional_constraint_2d", plane(alpha, constant, "integrated"));
    const Vec value = scene.reference.at(1.0).value;
    EXPECT_NEAR(value[0], q1, 1e-14) << alpha;
    EXPECT_NEAR(value[1], q2, 1e-14) << alpha;
    EXPECT_NEAR(scene.reactions.exact.at(1.0).value[0], lambda, 1e-14) << alpha;
    EXPECT_LT(scene.constraint.drift(1.0, value), 1e-15) << alpha;
  }
}

// f = a.v + b.w = C0 holds from the start, with w(0) along a.
TEST(AboveOrderOne, BothFormsApproachItForEveryConstant) {
  for (const KnownStart& at : known) {
    for (const auto* formulation : {"integrated", "multiplier"}) {
      Scene scene = scene_of("fractional_constraint_2d", plane(at.alpha, at.constant, formulation));
      scene.problem.end = 1.0;
      const auto error = [&](int steps) {
        const auto path = solve("product_trapezoidal", scene.problem, steps);
        EXPECT_LT(scene.constraint.drift(0.0, columns_of(scene.outputs, path).col(0)), 1e-15);
        EXPECT_LT(scene.constraint.drift(1.0, columns_of(scene.outputs, path).rightCols(1)), 1e-13);
        return std::hypot(path.y(0, steps) - at.q1, path.y(1, steps) - at.q2);
      };
      EXPECT_LT(error(1024), 2e-4) << at.alpha << formulation;
      EXPECT_LT(error(1024), 0.55 * error(512)) << at.alpha << formulation;
    }
  }
}

// v has a row of order alpha - 1 instead of order 1.
TEST(AboveOrderOne, TheFormWithAMultiplierTakesOtherSteps) {
  const auto end = [](double alpha, const std::string& formulation) -> Vec {
    ParameterValues values = plane(alpha, std::string("a1*v1+a2*v2"), formulation);
    const Scene scene = scene_of("fractional_constraint_2d", values);
    return columns_of(scene.outputs, solve("product_trapezoidal", scene.problem, 500)).rightCols(1);
  };
  for (const double alpha : {0.5, 1.0})
    EXPECT_LT((end(alpha, "integrated") - end(alpha, "multiplier")).norm(), 1e-12) << alpha;
  for (const double alpha : {1.25, 1.5, 1.75})
    EXPECT_GT((end(alpha, "integrated") - end(alpha, "multiplier")).norm(), 1e-7) << alpha;
}

// The reference does not depend on the formulation, nor on whether it can be posed: a.b = 0.
TEST(AboveOrderOne, TheReferenceIsThatOfEveryFormulation) {
  const SceneFactory& factory = scene_factory("fractional_constraint_2d");
  ParameterValues values{{"alpha", 1.5}, {"b1", 0.6}, {"b2", -0.3}};
  const auto at_three = [&](const std::string& formulation) -> Vec {
    values["formulation"] = formulation;
    return reference_of(make_scene_unchecked(factory, values)).at(3.0).value;
  };
  const Vec known_there = at_three("multiplier");
  for (const auto* formulation : {"integrated", "acceleration", "stabilised"}) {
    EXPECT_EQ(at_three(formulation), known_there) << formulation;
    expect_message([&] { make_scene(factory, values); }, "formulation = " + std::string(formulation));
  }
}

TEST(AboveOrderOne, OtherConstantsAreRefusedWhereTheStartFixesIt) {
  const auto refused = [](const ParameterValues& values, const std::string& reason) {
    expect_message([&] { scene_of("fractional_constraint_2d", values); }, reason);
  };
  refused({{"alpha", 0.5}, {"C0", 1.0}}, "C0 = 1: must be a1*v1+a2*v2 = 0 for alpha below 1");
  refused({{"alpha", 1.0}, {"C0", 0.0}}, "C0 = 0: must be (a1+b1)*v1+(a2+b2)*v2 = 0.26 for alpha = 1");
  refused(
      {{"alpha", 1.5}, {"b1", 0.6}, {"b2", -0.3}, {"C0", 1.0}, {"formulation", std::string("multiplier")}},
      "C0 = 1: must be a1*v1+a2*v2 = 0 for a.b = 0");
  EXPECT_NO_THROW(scene_of("fractional_constraint_2d", {{"C0", 0.0}}));
}

// w = v, so (a + b).v is conserved, and the initial velocity does not jump.
TEST(AtOrderOne, TheConstraintIsThatOfTheVelocityAlone) {
  for (const auto* formulation : {"integrated", "acceleration", "stabilised", "multiplier"}) {
    const Scene scene =
        scene_of("fractional_constraint_2d", {{"alpha", 1.0}, {"formulation", std::string(formulation)}});
    const Vec start = scene.reference.at(0.0).value;
    EXPECT_NEAR((start - Vec{{1.0, 0.0, 0.4, -0.2, 0.4, -0.2}}).norm(), 0.0, 1e-15) << formulation;
    const auto path = solve("product_trapezoidal", scene.problem, 1024);
    const Rows columns = columns_of(scene.outputs, path);
    EXPECT_NEAR((columns.col(0).head(6) - start.head(6)).norm(), 0.0, 1e-15) << formulation;
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
      EXPECT_NEAR(1.5 * columns(2, c) + 1.7 * columns(3, c), 0.26, 1e-13) << formulation;
    EXPECT_LT((columns.rightCols(1) - scene.reference.at(10.0).value).norm(), 1e-3) << formulation;
  }
}

}  // namespace
}  // namespace fde::bench
