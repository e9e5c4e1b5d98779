// SPDX-License-Identifier: MIT
// Constrained motion compared with the conditional extremum: Tarasov & Zaslavsky (67) and the residual of
// (72).

#include "fdebench/benchmarks/mechanics/formulations/conditional_extremum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fdebench/benchmarks/mechanics/extremum_residual.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

// f = d/dt phi with phi = q1^2 + q2 q3 + t q1, and with phi = |q|^2/2: differentiated holonomic constraints.
struct Derived {
  static constexpr int coordinates = 3, constraints = 2;
  template <class S>
  [[nodiscard]] Vector<S, 2> constraint(const S& t, const Vector<S, 3>& q, const Vector<S, 3>& v) const {
    return {2.0 * q[0] * v[0] + v[1] * q[2] + q[1] * v[2] + q[0] + t * v[0],
            q[0] * v[0] + q[1] * v[1] + q[2] * v[2]};
  }
};

template <int n>
Vector<double, n> some(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Vector<double, n>::NullaryExpr([&] { return uniform(generator); });
}

TEST(ExtremumResidual, IsZeroForDerivativesOfFunctionsOfThePlace) {
  std::mt19937 generator(3);
  for (int i = 0; i < 20; ++i) {
    const MotionState<3> at{0.4, some<3>(generator), some<3>(generator), some<3>(generator)};
    EXPECT_LT(extremum_residual(Derived{}, at, some<2>(generator)).cwiseAbs().maxCoeff(), 1e-13);
  }
}

// mu (y', -x', 0), projected along (-y, 0, 1).
TEST(ExtremumResidual, OfTheParticle) {
  const MotionState<3> at{0.0, {0.2, 0.5, 0.1}, {2.0, 3.0, 1.0}, {0.3, 0.0, -0.4}};
  const Vector<double, 3> expected = 1.5 * Vector<double, 3>(3.0 / 1.25, -2.0, 0.5 * 3.0 / 1.25);
  EXPECT_LT((extremum_residual(Particle{}, at, Vector<double, 1>(1.5)) - expected).norm(), 1e-15);
  EXPECT_EQ(extremum_residual(Particle{}, at, Vector<double, 1>(0.0)).norm(), 0.0);
}

// q'' of the extremum by differences along its flow, minus q'' of the motion at the same q and v: the
// residual with its index raised.
template <class System>
void expect_residual_between(const System& system, const InitialState<System::coordinates>& start,
                             const Vector<double, System::constraints>& multiplier) {
  constexpr int n = System::coordinates;
  using State = Vector<double, 2 * n>;
  const ConditionalExtremum<System> extremum{system, start, multiplier};
  State y;
  for (int i = 0; i < 2 * n; ++i) y[i] = extremum.components()[static_cast<std::size_t>(i)].initial[0];
  const State f = extremum.template rhs<double>(0.0, y);
  EXPECT_LT((f.template head<n>() - start.v).norm(), 1e-15);
  const auto at = [&](double h) {
    return Vector<double, n>(extremum.template rhs<double>(0.0, y + h * f).template head<n>());
  };
  const Vector<double, n> acceleration = (at(1e-5) - at(-1e-5)) / 2e-5;
  const Vector<double, n> motion = AccelerationWithoutMemory<System>{system, start, 0.0}
                                       .template rhs<double>(0.0, State(stacked<double>(start.q, start.v)))
                                       .template tail<n>();
  const Vector<double, n> residual =
      extremum_residual(system, {0.0, start.q, start.v, acceleration}, multiplier);
  EXPECT_GT(residual.norm(), 0.1);
  EXPECT_LT((acceleration - motion - raise_index<double>(system, start.q, residual)).norm(), 1e-8);
}

TEST(ExtremumResidual, IsTheDifferenceOfTheAccelerations) {
  expect_residual_between(Particle{}, {{0.1, 0.5, 0.3}, {2.0, 3.0, 1.0}}, Vector<double, 1>(1.5));
  expect_residual_between(Blade{4.0}, {{0.1, 0.2, 0.3}, {std::cos(0.3), std::sin(0.3), 0.7}},
                          Vector<double, 1>(1.2));
  const double rolled = 0.5 * 1.2;
  expect_residual_between(Disc{0.5, 2.0, 0.3, 0.2, 0.4},
                          {{0.1, 0.2, 0.3, 0.4}, {rolled * std::cos(0.3), rolled * std::sin(0.3), 0.7, 1.2}},
                          Vector<double, 2>(1.2, -0.7));
}

// In two dimensions every constraint a(q) v = 0 is a multiple of the derivative of some phi(q): extremum and
// motion coincide.
TEST(ExtremumResidual, IsZeroWithTwoCoordinates) {
  const MotionState<2> at{0.0, {0.7, 0.2}, {0.4, 0.8 / std::sin(0.7)}, {0.3, -0.9}};
  EXPECT_LT(extremum_residual(ConstantCourseOnSphere{2.0}, at, Vector<double, 1>(1.5)).norm(), 1e-15);
}

// The constraints of a rolling disc are nonholonomic, and yet each of its free motions is an extremum, with
// mu(0) = -m (x', y'): then mu = -m (x', y') at all times. With another mu(0) it is not.
TEST(ConditionalExtremum, EveryFreeMotionOfTheDiscIsOne) {
  const Scene disc = scene_of("rolling_disc");
  const double mass = 1.0, radius = 0.5, spin = 2.0;
  const auto extremum = [&](double times) {
    const MechanicalSetup<Disc> setting{.system = {radius, mass, 0.125, 0.0625, 0.0},
                                        .start = {Vector<double, 4>::Zero(), {radius * spin, 0.0, 1.0, spin}},
                                        .coordinates = {"x", "y", "phi", "psi"}};
    Scene scene = extremum_scene(setting, Vector<double, 2>(-times * mass * radius * spin, 0.0));
    scene.problem.end = 3.0;
    return Vec(reference_of(scene).at(3.0).value);
  };
  const Vec motion = disc.reference.at(3.0).value;
  EXPECT_LT((extremum(1.0) - motion).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT((extremum(0.5) - motion).cwiseAbs().maxCoeff(), 0.1);
}

// mu = (pz - y px)/(1 + y^2) remains 0 if y or x is constant.
TEST(VakonomicParticle, IsTheMotionWhereTheMultiplierStaysZero) {
  for (const auto* still : {"dx0", "dy0"}) {
    const ParameterValues values{{still, 0.0}};
    const Vec motion = scene_of("nonholonomic_particle", values).reference.at(3.0).value;
    const Vec extremum = reference_of(scene_of("vakonomic_particle", values)).at(3.0).value;
    EXPECT_LT((extremum - motion).cwiseAbs().maxCoeff(), 1e-14) << still;
  }
}

// The difference is initially t^2/2 times the residual at the start, mu0 (y', -x', y y') with y' and y y'
// divided by 1 + y^2.
TEST(VakonomicParticle, LeavesTheMotionWithTheResidual) {
  const double t = 1e-3, mu = 2.0;
  const Vec motion = scene_of("nonholonomic_particle").reference.at(t).value;
  const Vec extremum = reference_of(scene_of("vakonomic_particle", {{"mu0", mu}})).at(t).value;
  const Vector<double, 3> left = (extremum - motion).head<3>() / (t * t / 2);
  EXPECT_LT((left - mu * Vector<double, 3>(0.8, -1.0, 0.4)).norm(), 2e-3);
}

TEST(VakonomicParticle, KeepsConstraintEnergyAndMomenta) {
  const Scene scene = scene_of("vakonomic_particle", {{"mu0", 0.7}});
  const auto path = solve("product_trapezoidal", scene.problem, 1000);
  const Rows columns = columns_of(scene.outputs, path);
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    EXPECT_LT(scene.constraint.drift(0.0, columns.col(c)), 1e-14);
    EXPECT_NEAR(path.y(3, c), path.y(3, 0), 1e-14);
    EXPECT_NEAR(path.y(5, c), path.y(5, 0), 1e-14);
  }
  const reference::Reference reference = reference_of(scene);
  const double start = scene.energy.value(reference.at(0.0).value);
  EXPECT_NEAR(scene.energy.value(reference.at(5.0).value), start, 1e-13);
  EXPECT_GT(
      std::abs(reference.at(5.0).value[0] - scene_of("nonholonomic_particle").reference.at(5.0).value[0]),
      0.1);
}

}  // namespace
}  // namespace fde::bench
