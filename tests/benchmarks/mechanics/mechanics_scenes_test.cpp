// SPDX-License-Identifier: MIT
// Mechanics with constraints of integer order: derivatives, formulations, thermostats.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"
#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// The derivative of a function of two variables in direction k by differences.
template <class Function>
Vec slope_of(const Function& function, const Eigen::Vector2d& at, int k) {
  constexpr double h = 1e-6;
  const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(k);
  return (function(Vec(at + step)) - function(Vec(at - step))) / (2 * h);
}

const Eigen::Vector2d place(0.7, 0.3), speed(0.4, -0.9);

TEST(Derivatives, OfAConstraintAreThoseByDifferences) {
  const DynamicsOfFile sphere(scene_factory("loxodrome").toml);
  const auto& motion = sphere.dynamics;
  const Matrix directions = sphere.values(motion.reaction_directions(), 0.0, {place, speed});
  double flow = 0.0;
  for (int k = 0; k < 2; ++k) {
    const auto of_speed = [&](const Vec& v) { return sphere.values(motion.constraint(), 0.0, {place, v}); };
    const auto of_place = [&](const Vec& q) { return sphere.values(motion.constraint(), 0.0, {q, speed}); };
    EXPECT_NEAR(directions(0, k), slope_of(of_speed, speed, k)[0], 1e-9);
    flow += slope_of(of_place, place, k)[0] * speed[k];
  }
  EXPECT_NEAR(sphere.values(motion.convective_rate(), 0.0, {place, speed})[0], flow, 1e-9);
}

// G v' = -(d/dt (G v) - 1/2 grad(v'G v) - G v') without forces.
TEST(Derivatives, OfAMetricAreThoseByDifferences) {
  const DynamicsOfFile sphere(scene_factory("loxodrome").toml);
  const auto metric = [&](const Vec& q) { return sphere.values(sphere.dynamics.metric(), 0.0, {q, speed}); };
  const auto momentum = [&](const Vec& q) -> Vec { return metric(q) * speed; };
  Eigen::Vector2d terms = Eigen::Vector2d::Zero();
  for (int k = 0; k < 2; ++k) {
    const Vec slope = slope_of(momentum, place, k);
    terms += slope * speed[k];
    terms[k] -= 0.5 * slope.dot(speed);
  }
  const Vec free = sphere.values(sphere.dynamics.free_acceleration(), 0.0, {place, speed});
  EXPECT_LT((metric(place) * free + terms).norm(), 1e-9);
}

// The same kinetic energy, written as a metric that depends on the place.
TEST(Metric, OfTheIdentityIsNone) {
  const WrittenSystem particle{.coordinates = {"x", "y", "z"},
                               .position = {0.0, 0.5, 0.0},
                               .velocity = {1.0, 1.0, 0.5},
                               .lagrangian = "(sin(y)^2 + cos(y)^2)*(D(x,1)^2 + D(y,1)^2 + D(z,1)^2)/2",
                               .constraints = {"D(z,1) - y*D(x,1)"}};
  const Problem with = scene_of_mechanical_file(mechanical_file_of(particle)).problem,
                without = scene_of("nonholonomic_particle").problem;
  const Vec y = Vec{{0.3, -0.7, 0.2, 1.1, 0.4, -0.6}};
  Vec f(6), g(6);
  with.rhs(0.5, y, f);
  without.rhs(0.5, y, g);
  EXPECT_LT((f - g).norm(), 1e-15);
}

// On the constraint all formulations have the same v'. Off it the stabilised one differs by -kappa f /
// |df/dv|^2 along df/dv.
TEST(Formulations, AgreeOnTheConstraint) {
  const auto rate = [](const std::string& formulation, const Vec& y) {
    const Scene scene = scene_of("nonholonomic_particle", {{"formulation", formulation}, {"kappa", 10.0}});
    Vec f(6);
    scene.problem.rhs(0.0, y, f);
    return f;
  };
  Vec y = Vec{{0.0, 0.5, 0.0, 1.0, 1.0, 0.5}};
  EXPECT_EQ((rate("acceleration", y) - rate("stabilised", y)).norm(), 0.0);
  y[5] += 0.1;
  const Vec difference = rate("stabilised", y) - rate("acceleration", y);
  const Eigen::Vector3d expected = -10.0 * 0.1 / 1.25 * Eigen::Vector3d(-0.5, 0.0, 1.0);
  EXPECT_LT((difference.tail(3) - expected).norm(), 1e-15);
  EXPECT_EQ(difference.head(3).norm(), 0.0);
}

// lambda(0) = x' y' / (1 + y^2), and the reaction of the multiplier form equals that of the others.
TEST(Formulations, MultipliersStartConsistently) {
  const Scene multiplier = scene_of("nonholonomic_particle", {{"formulation", "multiplier"}});
  const Scene acceleration = scene_of("nonholonomic_particle", {{"formulation", "acceleration"}});
  ASSERT_EQ(multiplier.problem.size(), 7);
  EXPECT_EQ(multiplier.problem.components[6].order, 0.0);
  Vec y(7), f(7), g(6);
  for (Eigen::Index i = 0; i < 7; ++i)
    y[i] = multiplier.problem.components[static_cast<std::size_t>(i)].initial[0];
  EXPECT_NEAR(y[6], 0.8, 1e-15);
  multiplier.problem.rhs(0.0, y, f);
  acceleration.problem.rhs(0.0, y.head(6), g);
  EXPECT_LT((f.head(6) - g).norm(), 1e-15);
  EXPECT_EQ(f[6], 0.0);
}

double drift_at_end(const Scene& scene, std::string_view scheme, int steps) {
  const auto path = solve(scheme, scene.problem, steps);
  return scene.constraint.drift(scene.problem.end, columns_of(scene.outputs, path).rightCols(1));
}

TEST(Formulations, OnlyTheAccelerationFormsDrift) {
  for (const auto* id : {"nonholonomic_particle", "knife_edge", "rolling_disc", "loxodrome"}) {
    EXPECT_LT(drift_at_end(scene_of(id, {{"formulation", "integrated"}}), "adams_pc", 500), 1e-14) << id;
  }
  EXPECT_GT(
      drift_at_end(scene_of("nonholonomic_particle", {{"formulation", "acceleration"}}), "adams_pc", 500),
      1e-7);
}

// f' = 0 and f' = -kappa f: an initial violation of the constraint persists, or decays like e^(-kappa t).
TEST(Formulations, TheStabilisedOneForgetsAnInconsistentStart) {
  const auto drift = [](const std::string& formulation) {
    Scene scene = scene_of("nonholonomic_particle", {{"formulation", formulation}, {"kappa", 4.0}});
    scene.problem.end = 1.0;
    scene.problem.components[5].initial[0] += 0.1;
    return drift_at_end(scene, "product_trapezoidal", 4000);
  };
  EXPECT_NEAR(drift("acceleration"), 0.1, 1e-6);
  EXPECT_NEAR(drift("stabilised"), 0.1 * std::exp(-4.0), 1e-6);
}

TEST(Isokinetic, KeepsTheKineticEnergyThatItStartsWith) {
  const Scene scene = scene_of("isokinetic");
  const reference::Reference reference = reference_of(scene);
  for (const double t : {0.0, 2.0, 9.0}) {
    const reference::ReferenceValue at = reference.at(t);
    EXPECT_NEAR(at.value.tail<3>().squaredNorm() / 2, 0.305, 1e-13);
    EXPECT_LT(scene.constraint.drift(t, at.value), 1e-13);
    EXPECT_LT(at.bound.maxCoeff(), 1e-11);
  }
  EXPECT_EQ(scene_of("isokinetic", {{"v1", 2.0}}).problem.components[3].initial[0], 2.0);
}

// Without springs the motion is uniform.
TEST(Isokinetic, IsFreeMotionWithoutForces) {
  const Vec end = reference_of(scene_of("isokinetic", {{"k", 0.0}, {"c", 0.0}})).at(10.0).value;
  EXPECT_LT((end.head<3>() - Eigen::Vector3d(6.5, -4.0, 2.7)).norm(), 1e-13);
}

// The thermostat does work, dE/dt = 2 K lambda, and the residual of the energy balance decreases like h^2.
TEST(Isokinetic, EnergyBalanceClosesAtTheRateOfTheScheme) {
  const Scene scene = scene_of("isokinetic");
  const auto residual = [&](int steps) {
    EnergyObserver balance(scene.energy);
    const auto path = solve("product_trapezoidal", scene.problem, steps);
    for (int n = 0; n <= steps; ++n) balance.observe(path.time(n), path.y.col(n));
    return *balance.residual();
  };
  const Vec first = reference_of(scene).at(0.0).value;
  EXPECT_GT(std::abs(scene.energy.power(0.0, first)), 0.01);
  const double coarse = residual(500), fine = residual(1000);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

const ParameterValues unequal{{"gamma1", 0.2}, {"gamma2", 0.5}, {"gamma3", 1.0}};

// The columns q and v are compared with Taylor's method in 20 digits.
TEST(CanonicalEnsemble, KeepsItsTemperatureOnTheMotionComputedApart) {
  const Scene scene = scene_of("canonical_ensemble", unequal);
  const reference::ReferenceValue at = reference_of(scene).at(2.0);
  const Vec known = Vec{{-0.48124897378306242978, 0.36247456148944843572, 0.22127991052634237645,
                         -0.71410159757428311251, 0.46563544752866334600, 0.17777400448536345258}};
  EXPECT_LT((at.value - known).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT(scene.constraint.drift(2.0, at.value), 1e-13);
  const auto temperature = [&](In columns) {
    return Eigen::Vector3d(0.2, 0.5, 1.0).dot(columns.tail<3>().cwiseAbs2()) / 1.7;
  };
  EXPECT_NEAR(temperature(at.value), temperature(reference_of(scene).at(0.0).value), 1e-13);
}

// A friction that is equal for all masses is along the reaction.
TEST(CanonicalEnsemble, WithEqualFrictionsIsTheIsokineticOne) {
  const ParameterValues equal{{"gamma1", 0.7}, {"gamma2", 0.7}, {"gamma3", 0.7}};
  const Vec same = reference_of(scene_of("canonical_ensemble", equal)).at(5.0).value;
  const Vec isokinetic = reference_of(scene_of("isokinetic")).at(5.0).value;
  EXPECT_LT((same - isokinetic).cwiseAbs().maxCoeff(), 1e-12);
  const Vec other = reference_of(scene_of("canonical_ensemble", unequal)).at(5.0).value;
  EXPECT_GT((other - isokinetic).cwiseAbs().maxCoeff(), 0.05);
}

std::string complaint(std::string_view scene, const ParameterValues& values) {
  return message_of<std::invalid_argument>([&] { scene_of(scene, values); });
}

TEST(MechanicsParameters, AreRefusedWithWhatIsAllowed) {
  EXPECT_EQ(complaint("isokinetic", {{"v1", 0.0}, {"v2", 0.0}, {"v3", 0.0}}),
            "v1 = 0: must be other than 0 where v2 = 0 and v3 = 0: nothing would move");
  EXPECT_EQ(complaint("canonical_ensemble", {{"v1", 0.0}, {"v2", 0.0}}),
            "v1 = 0: must be such that a mass with friction moves");
  EXPECT_EQ(complaint("isobaric_ensemble", {{"v1", 0.0}, {"v2", 0.0}}),
            "v1 = 0: must be other than 0 where v2 = 0");
  EXPECT_EQ(complaint("loxodrome", {{"speed", 0.0}}), "speed = 0: must be a finite number above 0");
  EXPECT_EQ(complaint("loxodrome", {{"theta0", 0.0}}),
            "theta0 = 0: must be a number in (0, 3.141592653589793)");
  EXPECT_EQ(complaint("rolling_disc", {{"m", -1.0}}), "m = -1: must be a finite number above 0");
  const auto& choices =
      parameter_named("formulation", "isokinetic", scene_factory("isokinetic").parameters).choices;
  EXPECT_EQ(choices, (std::vector<std::string>{"acceleration", "stabilised", "multiplier"}));
}

}  // namespace
}  // namespace fde::bench
