// SPDX-License-Identifier: MIT
// Constraints with a reaction whose direction depends on the motion: the multiplier in nonlinear problems.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class Nonholonomic : public SchemeTest {
 protected:
  static Trajectory run(const Problem& problem, int steps, const Options& options = {}) {
    auto path = SchemeTest::run(problem, steps, options);
    EXPECT_EQ(path.status, SolveStatus::finished) << path.last_time;
    return path;
  }
};

INSTANTIATE_TEST_SUITE_P(, Nonholonomic, testing::ValuesIn(implicit_schemes()), id_of_param);

std::vector<Component> components(const std::vector<double>& initial, std::size_t of_order_one, double rest) {
  std::vector<Component> all;
  for (std::size_t i = 0; i < initial.size(); ++i) {
    const bool last = i + 1 == initial.size();
    all.push_back({last ? 0.0 : i < of_order_one ? 1.0 : rest, {initial[i]}});
  }
  return all;
}

// z' = y x', free otherwise, from (x, y, z) = 0 with x'(0) = y'(0) = 1: y = t, x = asinh t,
// z = sqrt(1 + t^2) - 1, lambda = x' y' / (1 + y^2). Unknowns (x, y, z, their velocities, lambda).
Problem particle(double initial_multiplier) {
  return {.components = components({0, 0, 0, 1, 1, 0, initial_multiplier}, 6, 0.0),
          .rhs =
              [](double, In u, Out f) {
                f.head(3) = u.segment(3, 3);
                f[3] = -u[1] * u[6];
                f[4] = 0.0;
                f[5] = u[6];
                f[6] = u[5] - u[1] * u[3];
              },
          .end = 2.0};
}

// A wrong initial multiplier does not change the rate.
TEST_P(Nonholonomic, TheParticleHasItsRate) {
  const double t = 2.0, x = std::asinh(t), z = std::hypot(1.0, t) - 1.0;
  for (const double initial_multiplier : {1.0, 3.0}) {
    std::vector<ErrorSample> points;
    for (int steps = 128; steps <= 2048; steps *= 2) {
      const Vec end = run(particle(initial_multiplier), steps).y.col(steps);
      EXPECT_NEAR(end[1], t, 1e-12);
      points.push_back({t / steps, std::max(std::abs(end[0] - x), std::abs(end[2] - z))});
    }
    const Fit fit = fit_rate(points);
    EXPECT_EQ(fit.points, 5U);
    EXPECT_NEAR(fit.slope, GetParam()->id == "product_trapezoidal" ? 2.0 : 1.0, 0.1);
    EXPECT_GT(fit.correlation, 0.999);
  }
}

TEST_P(Nonholonomic, TheMultiplierOfTheParticleIsFound) {
  const auto path = run(particle(1.0), 2048);
  for (const int n : {512, 1024, 2048}) {
    const double t = path.time(n);
    EXPECT_NEAR(path.y(6, n), std::pow(1.0 + t * t, -1.5), 1e-3) << n;
  }
}

// Two unit masses on springs, |v|^2/2 + coupling v.w = K, w = D^0.6 q: the isokinetic thermostat, and a
// nonlinear fractional constraint. Unknowns (q, v, w, lambda).
struct Thermostat {
  double coupling;
  double constraint_at_start = 0.5 * (1.0 + 0.25);

  [[nodiscard]] double constraint(In u) const {
    return u.segment(2, 2).squaredNorm() / 2 + coupling * u.segment(2, 2).dot(u.segment(4, 2)) -
           constraint_at_start;
  }
  [[nodiscard]] Problem problem(double end) const {
    return {.components = components({0.3, -0.2, 1.0, 0.5, 0.0, 0.0, 0.0}, 4, 0.4),
            .rhs =
                [self = *this](double, In u, Out f) {
                  f.head(2) = u.segment(2, 2);
                  f[2] = -2.0 * u[0] + u[1];
                  f[3] = -2.0 * u[1] + u[0];
                  f.segment(2, 2) += u[6] * (u.segment(2, 2) + self.coupling * u.segment(4, 2));
                  f.segment(4, 2) = u.segment(2, 2);
                  f[6] = self.constraint(u);
                },
            .end = end};
  }
};

TEST_P(Nonholonomic, ANonlinearConstraintIsHeldAtEveryStep) {
  for (const double coupling : {0.0, 0.3}) {
    for (int steps = 64; steps <= 4096; steps *= 4) {
      const Thermostat thermostat{coupling};
      double drift = 0.0;
      run(thermostat.problem(2.0), steps, {.output_times = {2.0}, .observer = [&](double, In u) {
                                             drift = std::max(drift, std::abs(thermostat.constraint(u)));
                                           }});
      EXPECT_LT(drift, 4e-15) << coupling << ' ' << steps;
    }
  }
}

TEST_P(Nonholonomic, ANonlinearConstraintIsHeldInShortSteps) {
  for (const double h : {1e-5, 1e-7, 1e-9}) {
    const Thermostat thermostat{0.3};
    const auto path = run(thermostat.problem(256 * h), 256);
    for (const auto& u : path.y.colwise()) ASSERT_LT(std::abs(thermostat.constraint(u)), 4e-15) << h;
    EXPECT_LT(path.cost.newton_iterations, 256 * 8) << h;
  }
}

// The multiplier is known only to rounding / h = 1e-4 of its size; Newton's method must not iterate for more.
TEST_P(Nonholonomic, TheParticleTakesFewIterationsInShortSteps) {
  Problem fast = particle(1e12);
  fast.components[3].initial = fast.components[4].initial = {1e6};
  fast.end = 1e-9 * 512;
  const auto path = run(fast, 512);
  EXPECT_LT(path.cost.newton_iterations, 512 * 5);
  for (const auto& u : path.y.colwise()) ASSERT_LT(std::abs(u[5] - u[1] * u[3]), 1e-9);
}

TEST_P(Nonholonomic, TheToleranceBoundsTheDrift) {
  for (const double tolerance : {1e-4, 1e-8}) {
    const Thermostat thermostat{0.3};
    const auto path = run(thermostat.problem(2.0), 128, {.newton_tolerance = tolerance});
    for (const auto& u : path.y.colwise()) ASSERT_LT(std::abs(thermostat.constraint(u)), tolerance);
  }
}

}  // namespace
}  // namespace fde::bench
