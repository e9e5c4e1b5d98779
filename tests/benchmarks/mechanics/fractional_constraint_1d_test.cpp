// SPDX-License-Identifier: MIT
// a q' + b D^alpha q = C0 (Tarasov & Zaslavsky 2006, eqs 44-48) in its three ranges of alpha.

#include <array>
#include <cmath>

#include "support/linear_system_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Values = ParameterValues;

Scene line(const Values& values) { return scene_of("fractional_constraint_1d", values); }
double at(const Scene& scene, double t) { return scene.reference.at(t).value[0]; }

// q0 + q1 t E_{1-alpha,2}(-(b/a) t^(1-alpha)) with a = 0.3, b = 0.6, at t = 1.
TEST(FractionalConstraint1D, BelowOneIsAMittagLefflerFunction) {
  const auto precision = test_precision();
  const Scene scene = line({{"alpha", 0.3}, {"a", 0.3}, {"b", 0.6}, {"q0", 0.1}, {"q1", 0.7}});
  const auto e = reference::real_part<reference::BigReal>(mittag_leffler_digits("0.7", "2", "-2"));
  expect_equal(digits_at(scene.reference, 1.0)[0], reference::BigReal("0.1") + reference::BigReal("0.7") * e,
               "alpha = 0.3");
}

// q0 + q1 t + q2 t^2 E_{alpha-1,3}(-(a/b) t^(alpha-1)).
TEST(FractionalConstraint1D, AboveTwoIsAnother) {
  const auto precision = test_precision();
  const Scene scene = line({{"alpha", 2.3}, {"a", 0.6}, {"b", 0.3}, {"q0", 0.1}, {"q1", 0.7}, {"q2", -0.4}});
  const auto e = reference::real_part<reference::BigReal>(mittag_leffler_digits("1.3", "3", "-2"));
  expect_equal(digits_at(scene.reference, 1.0)[0], reference::BigReal("0.8") - reference::BigReal("0.4") * e,
               "alpha = 2.3");
}

// The corrected eq. 49: D^(alpha-1) q + w2 q = q''(0) t^(3-alpha)/Gamma(4-alpha) + w2 (q(0) + q'(0) t).
TEST(FractionalConstraint1D, AboveTwoIsTheFractionalOscillator) {
  for (const double alpha : {2.25, 2.5, 2.75}) {
    const double a = 2.0, b = 0.5, q0 = 1.0, q1 = 0.5, q2 = 0.3;
    const reference::Reference oscillator = reference::linear_reference(
        reference::LinearEquation{
            {{1.0, alpha - 1.0}, {a / b, 0.0}},
            {q0, q1},
            {{q2 / std::tgamma(4.0 - alpha), 3.0 - alpha}, {a / b * q0}, {a / b * q1, 1.0}}},
        {0.0});
    const Scene scene = line({{"alpha", alpha}, {"a", a}, {"b", b}, {"q0", q0}, {"q1", q1}, {"q2", q2}});
    for (const double t : {0.3, 2.0, 9.0})
      EXPECT_NEAR(at(scene, t), oscillator.at(t).value[0], 1e-14 * (1.0 + t)) << alpha << ' ' << t;
  }
}

TEST(FractionalConstraint1D, BetweenOneAndTwoIsUniformMotion) {
  for (const double alpha : {1.1, 1.5, 1.9, 2.0}) {
    const Scene scene = line({{"alpha", alpha}, {"a", 0.3}, {"b", 0.7}, {"q1", 0.9}});
    for (const auto& powers : scene.smoothness.powers) EXPECT_LE(powers.size(), 1U);
    EXPECT_NEAR(at(scene, 3.0), 1.0 + 0.9 * 3.0, 1e-15);
    const auto path = solve("product_trapezoidal", scene.problem, 64);
    EXPECT_NEAR(path.y(0, 64), 10.0, 2e-14) << alpha;
  }
}

// Every scheme that supports the chain, in every range of alpha: the rate is near 1 or higher. The number of
// steps increases by a factor 8, because the error of bdf2 changes sign between 256 and 512.
TEST(FractionalConstraint1D, SchemesApproachIt) {
  for (const double alpha : {0.25, 0.5, 0.75, 2.25, 2.5, 2.75}) {
    Scene scene = line({{"alpha", alpha}});
    scene.problem.end = 4.0;
    for (const auto* scheme : grid_schemes()) {
      if (unsupported_reason(*scheme, scene.problem, Grid{4.0, 512})) {  // leading orders above 2
        EXPECT_TRUE(scheme->capabilities.discretises_equations && alpha > 2.0) << alpha << scheme->id;
        continue;
      }
      const auto error = [&](int steps) {
        return std::abs(solve(scheme->id, scene.problem, steps).y(0, steps) - at(scene, 4.0));
      };
      constexpr double rounding = 1e-13, halved = 0.55;
      EXPECT_LT(error(2048), std::max(std::pow(halved, 3.0) * error(256), rounding)) << alpha << scheme->id;
      EXPECT_LT(error(1024), 4e-3) << alpha << scheme->id;
    }
  }
}

// q, q', lambda = q''/a with a = 1, b = 0.5: series of Mittag-Leffler functions in 30 digits (mpmath).
TEST(FractionalConstraint1D, TakesEveryConstantAboveOne) {
  struct KnownCase {
    Values values;
    double t, q, v, lambda;
  };
  const std::array known{
      KnownCase{{{"alpha", 0.5}}, 1.0, 1.3597598554813643, 0.30784517209646294, -0.064086102862823337},
      KnownCase{
          {{"alpha", 1.5}, {"C0", 0.0}}, 1.0, 1.1890192513126914, 0.12769783815525287, -0.053398230926744799},
      KnownCase{{{"alpha", 1.5}, {"C0", 0.0}}, 2.0, 1.2975449407269249, NAN, NAN},
      KnownCase{{{"alpha", 2.5}, {"C0", 0.2}},
                2.0,
                1.7444311999180254,
                0.21062863593408901,
                -0.063609494435947699}};
  for (const auto& [values, t, q, v, lambda] : known) {
    const Scene scene = line(values);
    const Vec value = scene.reference.at(t).value;
    EXPECT_NEAR(value[0], q, 1e-15);
    EXPECT_LT(scene.constraint.drift(t, value), 1e-15);
    if (std::isnan(v)) continue;
    EXPECT_NEAR(value[1], v, 1e-15);
    EXPECT_NEAR(scene.reactions.exact.at(t).value[0], lambda, 1e-15);
  }
}

TEST(FractionalConstraint1D, ItsMultiplierStartsWithTheSecondDerivativeAboveTwo) {
  for (const double constant : {0.5, 0.2}) {
    const Scene scene = line({{"alpha", 2.5}, {"C0", constant}});
    EXPECT_EQ((*scene.reactions.initial_multipliers)[0], 0.3);
    EXPECT_NEAR(scene.reactions.exact.at(1e-14).value[0], 0.3, 1e-6);
  }
  EXPECT_FALSE(line({{"alpha", 1.5}, {"C0", 0.0}}).reactions.initial_multipliers);
}

TEST(FractionalConstraint1D, SchemesApproachTheConstraintThatIsZero) {
  for (const double alpha : {1.2, 1.5, 1.8, 2.5}) {
    Scene scene = line({{"alpha", alpha}, {"C0", 0.0}});
    scene.problem.end = 2.0;
    const auto error = [&](int steps) {
      const auto path = solve("product_trapezoidal", scene.problem, steps);
      const Vec columns = columns_of(scene.outputs, path).rightCols(1);
      EXPECT_LT(scene.constraint.drift(2.0, columns), 1e-15);
      return (columns - scene.reference.at(2.0).value).cwiseAbs().maxCoeff();
    };
    EXPECT_LT(error(1024), 1e-3) << alpha;
    EXPECT_LT(error(1024), 0.6 * error(512)) << alpha;
  }
}

// As alpha -> 1 from below, w(0) = 0, and q' changes from q1 to a q1 / (a + b) within a time that tends to 0;
// at order 1, w = q' from the start.
TEST(FractionalConstraint1D, AlphaToOneFromBelowIsAnotherMotionThanAtOne) {
  const Values at_one{{"alpha", 1.0}, {"a", 0.8}, {"b", 0.6}, {"q1", 0.7}};
  Values below = at_one;
  below["alpha"] = 1.0 - 0x1p-53;
  for (const double t : {0.5, 8.0}) {
    EXPECT_NEAR(at(line(at_one), t), 1.0 + 0.7 * t, 2e-15);
    EXPECT_NEAR(at(line(below), t), 1.0 + 0.8 * 0.7 * t / 1.4, 2e-15);
  }
}

// b q'' + a q' = C0 has q''(0) = (C0 - a q1) / b.
TEST(FractionalConstraint1D, AtOrderTwoTheMultiplierStartsAtAValue) {
  const Scene scene = line({{"alpha", 2.0}, {"C0", 0.1}});
  EXPECT_EQ(scene.reactions.initial_multipliers, Vec{{-0.8}});
  EXPECT_NEAR(scene.reactions.exact.at(0.0).value[0], -0.8, 1e-15);
}

TEST(FractionalConstraint1D, WithoutMemoryIsUniformMotion) {
  for (const double alpha : {0.4, 1.0, 1.6})
    EXPECT_NEAR(at(line({{"alpha", alpha}, {"b", 0.0}}), 2.0), 2.0, 1e-15) << alpha;
}

TEST(FractionalConstraint1D, OppositeSignsGrow) {
  EXPECT_GT(at(line({{"b", -2.0}}), 10.0), 1e10);
  EXPECT_GT(at(line({{"b", -2.0}, {"alpha", 2.5}}), 10.0), 1e2);
}

TEST(FractionalConstraint1D, RefusesWhatIsNoMotion) {
  expect_message([] { line({{"a", 0.0}}); }, "a = 0: must be other than 0 for alpha up to 1");
  expect_message([] { line({{"alpha", 1.0}, {"b", -1.0}}); }, "b = -1: must be other than -a for alpha = 1");
  expect_message([] { line({{"alpha", 2.5}, {"b", 0.0}}); }, "b = 0: must be other than 0 for alpha above 2");
  expect_message([] { line({{"alpha", 1.5}, {"a", 0.0}, {"b", 0.0}}); }, "a = 0: must be other than 0");
  expect_message([] { line({{"alpha", 3.0}}); }, "alpha");
  expect_message([] { line({{"C0", 0.0}}); }, "C0 = 0: must be a*q1 = 0.5 for alpha below 1");
  expect_message(
      [] {
        line({{"alpha", 1.0}, {"C0", 0.5}});
      },
      "C0 = 0.5: must be (a+b)*q1 = 0.75 for alpha = 1");
  expect_message(
      [] {
        line({{"alpha", 1.5}, {"b", 0.0}, {"C0", 0.0}});
      },
      "C0 = 0: must be a*q1 = 0.5 for b = 0");
}

}  // namespace
}  // namespace fde::bench
