// SPDX-License-Identifier: MIT
// The special cases of the two-dimensional constraint (Tarasov & Zaslavsky 2006, eqs 57-66).

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/nonlinear/collocation.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Values = ParameterValues;

// Eq. 57: the constraint does not act on q1, which is a harmonic oscillator.
TEST(ConstraintCases, A1ZeroLeavesQ1Free) {
  for (const double alpha : {0.3, 0.5, 0.8, 1.5}) {
    const Values values{{"alpha", alpha}, {"a1", 0.0}, {"k1", 2.25}, {"q1", 1.0}, {"v1", 0.6}};
    const auto [value, bound] = reference_of(scene_of("fractional_constraint_2d", values)).at(5.0);
    EXPECT_NEAR(value[0], std::cos(7.5) + 0.4 * std::sin(7.5), bound[0] + 1e-14) << alpha;
  }
}

// Eq. 58: a1 = b2 = 0 and q1 = cos t. a2 q2' = a2 q2'(0) - b1 D^alpha cos.
TEST(ConstraintCases, A1AndB2ZeroDriveQ2ByQ1) {
  for (const double alpha : {0.3, 0.5, 0.8}) {
    const Values values{{"alpha", alpha}, {"a1", 0.0}, {"b2", 0.0}, {"a2", 2.0}, {"b1", 0.5},
                        {"k1", 1.0},      {"q1", 1.0}, {"v1", 0.0}, {"v2", -0.2}};
    const auto [value, bound] = reference_of(scene_of("fractional_constraint_2d", values)).at(3.0);
    const reference::Reference cosine = reference::linear_reference(
        reference::LinearEquation{{{1.0, 2.0}, {1.0, 0.0}}, {1.0, 0.0}}, {0.0, alpha});
    EXPECT_NEAR(value[3], -0.2 - 0.25 * cosine.at(3.0).value[1], bound[3] + 1e-14) << alpha;
  }
}

Scene oscillator(Values values, const std::string& form) {
  values["form"] = form;
  return scene_of("nonlinear_fractional_oscillator", values);
}

// The reference computed from scene.problem instead of scene.reference_problem.
Vec own_reference(const Scene& scene, double t) {
  const reference::ReferenceValue known = reference::reference_solution(scene.problem).at(t);
  return columns_at(scene.outputs, t, known.value);
}

// Eqs 63-66: (66) and the system (59), (60) are different equations for the same motion.
TEST(ConstraintCases, TheReducedEquationIsTheSystem) {
  for (const double alpha : {1.25, 1.5, 1.75}) {
    Scene system = oscillator({{"alpha", alpha}}, "integrated");
    Scene reduced = oscillator({{"alpha", alpha}}, "reduced");
    system.problem.end = reduced.problem.end = 2.0;
    const reference::Reference of_reduced = reference::reference_solution(reduced.problem),
                               of_system = reference::reference_solution(system.problem);
    for (const double t : {0.1, 0.5, 2.0}) {
      const reference::ReferenceValue known = of_reduced.at(t), other = of_system.at(t);
      const Vec seen = columns_at(reduced.outputs, t, known.value),
                same = columns_at(system.outputs, t, other.value);
      const Vec bound = propagated_bound(reduced.outputs, t, known, seen) +
                        propagated_bound(system.outputs, t, other, same);
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(seen[c], same[c], bound[c]) << alpha << ' ' << t << ' ' << c;
      EXPECT_LT(bound.maxCoeff(), 1e-10);
    }
  }
}

// For K = k1 x the equation is x'' + (2/g) D^(3-alpha) x + (k1/2) x = 0, with an exact solution.
TEST(ConstraintCases, TheLinearOneIsExact) {
  const double alpha = 1.25, k1 = 3.0, g = 0.8;
  Scene system = oscillator({{"alpha", alpha}, {"k1", k1}, {"k3", 0.0}}, "integrated");
  system.problem.end = 2.0;
  const reference::Reference exact = reference::linear_reference(
      reference::LinearEquation{{{1.0, 2.0}, {2.0 / g, 3.0 - alpha}, {k1 / 2.0, 0.0}}, {0.7, 0.3}},
      {0.0, 1.0});
  EXPECT_LT((own_reference(system, 2.0) - exact.at(2.0).value).cwiseAbs().maxCoeff(), 1e-12);
}

// Eqs 59-62 in the plane scene: u = k (q1^2 - q2^2)/2 = 2 k x y.
TEST(ConstraintCases, ThePlaneHasTheSameCase) {
  const Values plane{{"alpha", 1.5}, {"a1", 1.0}, {"a2", 1.0}, {"b1", 0.0}, {"b2", 0.8}, {"k1", 0.5},
                     {"k2", -0.5},   {"q1", 0.5}, {"q2", 0.9}, {"v1", 0.8}, {"v2", -0.2}};
  const Vec points = reference_of(scene_of("fractional_constraint_2d", plane)).at(2.0).value;
  const reference::Reference exact = reference::linear_reference(
      reference::LinearEquation{{{1.0, 2.0}, {2.5, 1.5}, {0.5, 0.0}}, {0.7, 0.3}}, {0.0, 1.0});
  EXPECT_NEAR(0.5 * (points[0] + points[1]), exact.at(2.0).value[0], 1e-12);
  EXPECT_NEAR(0.5 * (points[2] + points[3]), exact.at(2.0).value[1], 1e-12);
}

// The initial values of y enter the system only, and do not affect x.
TEST(ConstraintCases, XDoesNotDependOnY) {
  Scene one = oscillator({}, "integrated"), other = oscillator({{"y0", 3.0}, {"dy0", -1.0}}, "integrated");
  const auto at_end = [](const Scene& scene) {
    const auto path = solve("product_trapezoidal", scene.problem, 400);
    return Vec(columns_of(scene.outputs, path).rightCols(1));
  };
  EXPECT_LT((at_end(one) - at_end(other)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ConstraintCases, TheMultiplierFormApproachesTheReducedEquation) {
  const Vec reference = reference_of(oscillator({}, "reduced")).at(2.0).value;
  Scene scene = oscillator({}, "multiplier");
  scene.problem.end = 2.0;
  const auto error = [&](int steps) {
    const auto path = solve("product_trapezoidal", scene.problem, steps);
    return (columns_of(scene.outputs, path).rightCols(1) - reference).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(error(800), 1e-3);
  EXPECT_LT(error(800), 0.55 * error(400));
}

// z' = -P grad u with P = I - a a^T/5, a = (1, 2): a large constant force must not cause cancellation in the
// small stiffness.
TEST(FractionalConstraint2d, AGreatForceLeavesTheMatrixOfASmallStiffness) {
  const auto scene = scene_of("fractional_constraint_2d", {{"g", 1e12}, {"k2", 1e-9}});
  const Matrix& part = std::get<DenseLinearPart>(scene.problem.derivatives).matrix;
  EXPECT_NEAR(part(2, 1), 0.4e-9, 1e-24);
  EXPECT_NEAR(part(3, 1), -0.2e-9, 1e-24);
}

}  // namespace
}  // namespace fde::bench
