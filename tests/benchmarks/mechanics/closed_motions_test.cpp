// SPDX-License-Identifier: MIT
// Closed forms of motions with constraints of integer order: they satisfy the equations, their bounds hold,
// and their limits are those of mechanics.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/real.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct Motion {
  std::string scene;
  ParameterValues values;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const Motion& motion, std::ostream* out) {
  *out << motion.scene;
  for (const auto& [name, value] : motion.values) *out << ' ' << name << '=' << to_text(value);
}

class ClosedMotion : public testing::TestWithParam<Motion> {
 protected:
  // The formulation whose state equals the columns.
  static Scene accelerated() {
    auto values = GetParam().values;
    values["formulation"] = "acceleration";
    return scene_of(GetParam().scene, values);
  }
  const Scene scene_ = accelerated();

  [[nodiscard]] Vec at(double t) const { return scene_.reference.at(t).value; }
  // Five-point differences: truncation error h^4, rounding error 1e-16/h.
  [[nodiscard]] Vec slope(double t) const {
    constexpr double h = 0x1p-9;
    return (8.0 * (at(t + h) - at(t - h)) - (at(t + 2 * h) - at(t - 2 * h))) / (12.0 * h);
  }
};

const std::vector<double> times{0.1, 0.7, 1.5, 3.0, 4.5};

TEST_P(ClosedMotion, SatisfiesTheEquationsOfMotion) {
  for (const double t : times) {
    const Vec columns = at(t);
    Vec f(columns.size());
    scene_.problem.rhs(t, columns, f);
    EXPECT_LT((slope(t) - f).cwiseAbs().maxCoeff(), 2e-9 * (1.0 + f.cwiseAbs().maxCoeff())) << "t = " << t;
  }
}

TEST_P(ClosedMotion, KeepsTheConstraintAndTheEnergy) {
  const double start = scene_.energy.value(at(0.0));
  for (const double t : times) {
    const Vec columns = at(t);
    const double size = columns.cwiseAbs().maxCoeff();
    EXPECT_LT(scene_.constraint.drift(t, columns), 4e-16 * (1.0 + size)) << "t = " << t;
    EXPECT_NEAR(scene_.energy.value(columns), start, 1e-15 * (1.0 + size * size)) << "t = " << t;
    EXPECT_NEAR(scene_.energy.power(t, columns), 0.0, 1e-14 * (1.0 + size * size)) << "t = " << t;
  }
}

// Compared with 40 digits; the bound itself is at the level of double precision.
TEST_P(ClosedMotion, IsWithinItsBound) {
  const reference::Precision precision(60);
  for (const double t : {0.0, 1e-9, 0.1, 1.5, 4.5}) {
    const reference::ReferenceValue quick = scene_.reference.at(t);
    const auto precise = scene_.reference.digits(t, 40);
    const double largest = quick.value.cwiseAbs().maxCoeff();
    for (Eigen::Index c = 0; c < quick.value.size(); ++c) {
      const auto& [value, bound] = precise[static_cast<std::size_t>(c)];
      const reference::BigReal error = abs(reference::BigReal(reference::parse<reference::BigReal>(value) -
                                                              reference::BigReal(quick.value[c])));
      EXPECT_LE(error, reference::BigReal(quick.bound[c]) + reference::parse<reference::BigReal>(bound))
          << "column " << c << ", t = " << t;
      EXPECT_LE(quick.bound[c], 1.2e-16 * (std::abs(quick.value[c]) + 1.0 + largest)) << "column " << c;
      const reference::BigReal size =
          std::max(reference::BigReal(abs(reference::parse<reference::BigReal>(value))),
                   reference::BigReal(1e-40));  // some are 0
      EXPECT_LE(reference::parse<reference::BigReal>(bound), reference::BigReal(1e-39) * size)
          << "column " << c;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , ClosedMotion,
    testing::Values(Motion{"nonholonomic_particle", {}},
                    Motion{"nonholonomic_particle", {{"y0", -2.0}, {"dy0", 1.3}, {"dx0", -0.7}}},
                    Motion{"nonholonomic_particle", {{"dy0", 1e-7}}},
                    Motion{"nonholonomic_particle", {{"dy0", 0.0}}}, Motion{"knife_edge", {}},
                    Motion{"knife_edge", {{"omega", -0.01}, {"g", 1.0}}},
                    Motion{"knife_edge", {{"omega", 0.0}, {"theta", 1.0}}}, Motion{"rolling_disc", {}},
                    Motion{"rolling_disc", {{"pull", 0.6}, {"m", 2.0}, {"R", 0.8}, {"dphi0", -0.4}}},
                    Motion{"rolling_disc", {{"pull", 0.6}, {"dphi0", 0.0}}},
                    Motion{"loxodrome", {{"speed", 0.5}}},
                    Motion{"loxodrome", {{"k", -0.5}, {"theta0", 1.2}, {"speed", 0.3}}},
                    Motion{"loxodrome", {{"k", 0.0}, {"speed", 0.3}}}),
    [](const auto& test) { return test.param.scene + "__" + std::to_string(test.index); });

// The bound is at most the effect of rounding t, which is t times the largest rate, also for a turning
// motion.
TEST(ClosedMotions, OfManyTurnsAreKnownAsWellAsTheirTime) {
  const reference::Precision precision(60);
  for (const Motion& motion :
       {Motion{"knife_edge", {{"omega", 1.7}}}, Motion{"rolling_disc", {{"pull", 0.6}, {"dphi0", -0.4}}}}) {
    const Scene scene = scene_of(motion.scene, motion.values);
    for (const double t : {1e6, 1e12, 1e20}) {
      const auto [value, bound] = scene.reference.at(t);
      const Eigen::Index n = value.size() / 2;
      const auto precise = scene.reference.digits(t, 40);
      for (Eigen::Index c = 0; c < n; ++c) {
        const double largest_rate = 10.0;  // of both motions
        EXPECT_LE(bound[c], 5e-16 * t * largest_rate) << motion.scene << ' ' << c << ", t = " << t;
        const auto exact = reference::parse<reference::BigReal>(precise[static_cast<std::size_t>(c)].value);
        EXPECT_LE(abs(reference::BigReal(exact - reference::BigReal(value[c]))), reference::BigReal(bound[c]))
            << motion.scene << ' ' << c;
      }
    }
  }
}

// To first order in b: x = dx0 (t - b y0 t^2 / (2 (1 + y0^2))).
TEST(NonholonomicParticle, MovesUniformlyAsYStandsStill) {
  const double y0 = 0.5, t = 3.0;
  EXPECT_EQ(scene_of("nonholonomic_particle", {{"dy0", 0.0}}).reference.at(t).value[0], t);
  const double b = 1e-9;
  const Vec almost = scene_of("nonholonomic_particle", {{"dy0", b}}).reference.at(t).value;
  const double lag = b * y0 * t * t / (2.0 * (1.0 + y0 * y0));
  EXPECT_NEAR(almost[0], t - lag, 5e-16 * t);
  EXPECT_NEAR((t - almost[0]) / lag, 1.0, 1e-6);
}

// (c/b)(arsinh y - arsinh y0) in the order of integration of the paper, c = sqrt(1.25).
TEST(NonholonomicParticle, HasTheIntegralsOfItsVelocities) {
  const Vec columns = scene_of("nonholonomic_particle").reference.at(2.0).value;
  const double c = std::sqrt(1.25);
  EXPECT_NEAR(columns[0], c * (std::asinh(2.5) - std::asinh(0.5)), 1e-15);
  EXPECT_NEAR(columns[2], c * (std::sqrt(7.25) - c), 2e-15);
}

// x = a t^2/2 (1 - (omega t)^2/3 + ...), y = a omega t^3/3 (1 - ...), a = g sin theta.
TEST(KnifeEdge, FallsStraightAsItStopsTurning) {
  const double a = std::sin(0.5), omega = 1e-5, t = 2.0;
  const Vec columns = scene_of("knife_edge", {{"g", 1.0}, {"omega", omega}}).reference.at(t).value;
  EXPECT_NEAR(columns[0] / (a * t * t / 2), 1.0 - omega * omega * t * t / 3, 1e-15);
  EXPECT_NEAR(columns[1] / (a * omega * t * t * t / 3), 1.0 - omega * omega * t * t / 5, 1e-15);
}

// It returns to x = 0 after each half turn and drifts along y at the mean speed a / (2 omega).
TEST(KnifeEdge, DriftsAcrossTheSlope) {
  const Vec columns = scene_of("knife_edge").reference.at(std::numbers::pi).value;
  EXPECT_NEAR(columns[0], 0.0, 1e-15);
  EXPECT_NEAR(columns[1], 9.81 * std::sin(0.5) / 2 * std::numbers::pi, 1e-14);
}

TEST(RollingDisc, RollsInACircle) {
  const reference::Reference exact = scene_of("rolling_disc", {{"dphi0", 0.5}, {"m", 3.0}}).reference;
  for (const double t : times) {
    const Vec columns = exact.at(t).value;
    EXPECT_NEAR(std::hypot(columns[0], columns[1] - 2.0), 2.0, 1e-15) << "t = " << t;
  }
}

// The fraction m R^2 / (m R^2 + I) of the pull accelerates it: straight motion, 2/3 of the pull for a solid
// disc.
TEST(RollingDisc, ResistsWithItsInertia) {
  const Scene scene =
      scene_of("rolling_disc", {{"pull", 0.75}, {"dphi0", 0.0}, {"dpsi0", 0.0}, {"I", 0.125}, {"m", 1.0}});
  EXPECT_NEAR(scene.reference.at(4.0).value[0], 0.75 * 2.0 / 3.0 * 8.0, 1e-15);
}

// tan of the angle to the meridians: sin(theta) dphi/dtheta = k; the speed is constant.
TEST(Loxodrome, KeepsCourseAndSpeed) {
  const reference::Reference exact = scene_of("loxodrome", {{"speed", 0.5}}).reference;
  for (const double t : times) {
    const Vec columns = exact.at(t).value;
    const double across = std::sin(columns[0]) * columns[3];
    EXPECT_NEAR(across / columns[2], 2.0, 1e-15);
    EXPECT_NEAR(std::hypot(across, columns[2]), 0.5, 1e-16);
  }
}

TEST(Loxodrome, EndsInThePole) {
  Scene scene = scene_of("loxodrome", {{"theta0", 3.0}, {"speed", 0.5}});
  const double pole = (std::numbers::pi - 3.0) * std::sqrt(5.0) / 0.5;
  EXPECT_NEAR(scene.problem.end, 0.9 * pole, 1e-15);
  scene.problem.end = 2.0;
  const Grid grid{2.0, 64};
  for (const auto* scheme : row_schemes()) {
    const auto path = scheme->solve(scene.problem, grid, {});
    EXPECT_NE(path.status, SolveStatus::finished) << scheme->id;
    EXPECT_GT(path.last_time, 0.7 * pole) << scheme->id;
    EXPECT_LE(path.last_time, pole + grid.step()) << scheme->id;
    EXPECT_TRUE(path.y.allFinite()) << scheme->id;
  }
  EXPECT_THROW(scene.reference.at(2.0), std::runtime_error);
}

TEST(ClosedForms, RefuseTimesBeforeTheStart) {
  EXPECT_THROW(scene_of("knife_edge").reference.at(-1.0), std::invalid_argument);
  EXPECT_THROW(scene_of("knife_edge").reference.digits(INFINITY, 20), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
