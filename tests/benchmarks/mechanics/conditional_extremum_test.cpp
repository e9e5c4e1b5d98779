// SPDX-License-Identifier: MIT
// Constrained motion compared with the conditional extremum: Tarasov & Zaslavsky (67) and the residual of
// (72).

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Eigen::Vector3d;

// The residual of a motion of a constrained system in the equations of a conditional extremum, a covector:
//   P^T mu (df/dq - d/dt df/dv),
// the factor of the variations delta q = P x, (df/dv) delta q = 0, in Tarasov & Zaslavsky (72). d/dt is along
// q' = v, v' = acceleration; mu' cancels.
class ExtremumResidual {
 public:
  explicit ExtremumResidual(std::string_view toml) : motion_(toml) {
    const auto& [system, algebra] = std::tie(motion_.system, motion_.algebra);
    auto& pool = algebra.pool();
    const auto n = system.size(), first = system.column_count() + 1;
    const auto variable = [&](std::size_t i) { return pool.variable(static_cast<int>(i)); };
    const auto& f = system.constraints;
    const auto by_place = algebra.jacobian(f, system.q()), by_velocity = algebra.jacobian(f, system.v());
    // The state moves by (1, v, v') in the variables (t, q, v).
    std::vector<int> moving{0};
    mechanics::Expressions rates{algebra.number(1.0)};
    for (std::size_t i = 0; i < 2 * n; ++i) moving.push_back(static_cast<int>(i) + 1);
    for (std::size_t i = 0; i < n; ++i) rates.push_back(variable(n + i + 1));
    for (std::size_t i = 0; i < n; ++i) rates.push_back(variable(first + i));
    const auto turning = algebra.product(algebra.jacobian(by_velocity.entries, moving), rates);
    mechanics::Expressions force(n, algebra.zero());
    for (std::size_t j = 0; j < f.size(); ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        const auto term = algebra.difference(by_place(j, i), turning[j * n + i]);
        force[i] = algebra.sum(force[i], algebra.product(variable(first + n + j), term));
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      mechanics::Expressions unit(n, algebra.zero());
      unit[i] = algebra.number(1.0);
      residual_.push_back(algebra.dot(force, motion_.dynamics.projected(unit)));
    }
  }

  [[nodiscard]] Vec at(double t, const Vec& q, const Vec& v, const Vec& acceleration, const Vec& mu) const {
    return motion_.values(residual_, t, {q, v, acceleration, mu});
  }

 private:
  DynamicsOfFile motion_;
  mechanics::Expressions residual_{};
};

constexpr const char* unit_masses = "(D(x,1)^2 + D(y,1)^2 + D(z,1)^2)/2";

Vec vector_of(const std::vector<double>& of) { return Eigen::Map<const Vec>(of.data(), std::ssize(of)); }

WrittenSystem particle_in_planes() {
  return {.coordinates = {"x", "y", "z"},
          .position = {0.1, 0.5, 0.3},
          .velocity = {2.0, 3.0, 1.0},
          .lagrangian = unit_masses,
          .constraints = {"D(z,1) - y*D(x,1)"}};
}

WrittenSystem blade_on_slope(double pull) {
  return {.coordinates = {"x", "y", "phi"},
          .position = {0.1, 0.2, 0.3},
          .velocity = {std::cos(0.3), std::sin(0.3), 0.7},
          .lagrangian = fmt::format("(D(x,1)^2 + D(y,1)^2 + D(phi,1)^2)/2 + {}*x", pull),
          .constraints = {"D(x,1)*sin(phi) - D(y,1)*cos(phi)"}};
}

// Of radius 1/2.
WrittenSystem disc_on_plane(double mass, double spin_inertia, double turn_inertia, double pull) {
  return {
      .coordinates = {"x", "y", "phi", "psi"},
      .position = {0.1, 0.2, 0.3, 0.4},
      .velocity = {0.6 * std::cos(0.3), 0.6 * std::sin(0.3), 0.7, 1.2},
      .lagrangian = fmt::format("({0}*(D(x,1)^2 + D(y,1)^2) + {1}*D(phi,1)^2 + {2}*D(psi,1)^2)/2 + {0}*{3}*x",
                                mass, turn_inertia, spin_inertia, pull),
      .constraints = {"D(x,1) - D(psi,1)*cos(phi)/2", "D(y,1) - D(psi,1)*sin(phi)/2"}};
}

Scene extremum_of(const WrittenSystem& system, const Vec& multipliers) {
  return scene_of_mechanical_file(mechanical_file_of(
      system, fmt::format("principle = \"vakonomic\"\nmultipliers = [{}]\n", fmt::join(multipliers, ", "))));
}

// f = d/dt phi with phi = x^2 + y z + t x, and with phi = |q|^2/2: differentiated holonomic constraints.
TEST(ExtremumResidual, IsZeroForDerivativesOfFunctionsOfThePlace) {
  const ExtremumResidual residual(
      mechanical_file_of({.coordinates = {"x", "y", "z"},
                          .position = {0.0, 0.0, 0.0},
                          .velocity = {0.0, 0.0, 0.0},
                          .lagrangian = unit_masses,
                          .constraints = {"2*x*D(x,1) + D(y,1)*z + y*D(z,1) + x + t*D(x,1)",
                                          "x*D(x,1) + y*D(y,1) + z*D(z,1)"}}));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto some = [&](Eigen::Index size) -> Vec {
    return Vec::NullaryExpr(size, [&] { return uniform(generator); });
  };
  for (int i = 0; i < 20; ++i) {
    const Vec q = some(3), v = some(3), acceleration = some(3), mu = some(2);
    EXPECT_LT(residual.at(0.4, q, v, acceleration, mu).cwiseAbs().maxCoeff(), 1e-13);
  }
}

// mu (y', -x', 0), projected along (-y, 0, 1).
TEST(ExtremumResidual, OfTheParticle) {
  const ExtremumResidual residual(mechanical_file_of(particle_in_planes()));
  const auto with = [&](double mu) {
    return residual.at(0.0, Vector3d(0.2, 0.5, 0.1), Vector3d(2.0, 3.0, 1.0), Vector3d(0.3, 0.0, -0.4),
                       Vec::Constant(1, mu));
  };
  EXPECT_LT((with(1.5) - 1.5 * Vector3d(3.0 / 1.25, -2.0, 0.5 * 3.0 / 1.25)).norm(), 1e-15);
  EXPECT_EQ(with(0.0).norm(), 0.0);
}

// q'' of the extremum by differences along its flow, minus q'' of the motion at the same q and v: the
// residual with its index raised.
void expect_residual_between(const WrittenSystem& system, const Vec& multipliers) {
  const auto n = std::ssize(system.coordinates);
  const Vec q = vector_of(system.position), v = vector_of(system.velocity);
  const Scene extremum = extremum_of(system, multipliers);
  const auto rate = [](const Scene& scene, const Vec& y) {
    Vec f(y.size());
    scene.problem.rhs(0.0, y, f);
    return f;
  };
  const Vec y = taylor_part(extremum.problem, 0.0), f = rate(extremum, y);
  EXPECT_LT((f.head(n) - v).norm(), 1e-15);
  const Vec acceleration = (rate(extremum, y + 1e-5 * f) - rate(extremum, y - 1e-5 * f)).head(n) / 2e-5;
  const std::string text = mechanical_file_of(system);
  const Scene motion = scene_of_mechanical_file(text, {{"formulation", "acceleration"}});
  const Vec of_motion = rate(motion, taylor_part(motion.problem, 0.0)).tail(n);
  const Vec residual = ExtremumResidual(text).at(0.0, q, v, acceleration, multipliers);
  EXPECT_GT(residual.norm(), 0.1);
  const Matrix metric = motion.geometry.at(q, v).metric;
  EXPECT_LT((acceleration - of_motion - metric.lu().solve(residual)).norm(), 1e-8);
}

TEST(ExtremumResidual, IsTheDifferenceOfTheAccelerations) {
  expect_residual_between(particle_in_planes(), Vec::Constant(1, 1.5));
  expect_residual_between(blade_on_slope(4.0), Vec::Constant(1, 1.2));
  expect_residual_between(disc_on_plane(2.0, 0.3, 0.2, 0.4), Eigen::Vector2d(1.2, -0.7));
}

// In two dimensions every constraint a(q) v = 0 is a multiple of the derivative of some phi(q): extremum and
// motion coincide.
TEST(ExtremumResidual, IsZeroWithTwoCoordinates) {
  const ExtremumResidual residual(scene_factory("loxodrome").toml);
  const Eigen::Vector2d q(0.7, 0.2), v(0.4, 0.8 / std::sin(0.7)), acceleration(0.3, -0.9);
  EXPECT_LT(residual.at(0.0, q, v, acceleration, Vec::Constant(1, 1.5)).norm(), 1e-15);
}

// The constraints of a rolling disc are nonholonomic, and yet each of its free motions is an extremum, with
// mu(0) = -m (x', y'): then mu = -m (x', y') at all times. With another mu(0) it is not.
TEST(ConditionalExtremum, EveryFreeMotionOfTheDiscIsOne) {
  const Scene disc = scene_of("rolling_disc");
  const auto extremum = [&](double times) {
    auto system = disc_on_plane(1.0, 0.125, 0.0625, 0.0);
    system.position = {0.0, 0.0, 0.0, 0.0};
    system.velocity = {1.0, 0.0, 1.0, 2.0};
    Scene scene = extremum_of(system, Eigen::Vector2d(-times, 0.0));
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
  const Vector3d left = (extremum - motion).head<3>() / (t * t / 2);
  EXPECT_LT((left - mu * Vector3d(0.8, -1.0, 0.4)).norm(), 2e-3);
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
