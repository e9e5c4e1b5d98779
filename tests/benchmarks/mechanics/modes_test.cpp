// SPDX-License-Identifier: MIT
// Growing modes of the linear scene: zeros of sum_i a_i (a_i + b_i s^(alpha-1)) / (s^2 + k_i), Tarasov &
// Zaslavsky (42).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Complex = std::complex<double>;

struct Plane {
  double alpha;
  std::array<double, 2> a, b, k;

  [[nodiscard]] Complex characteristic(Complex s) const {
    Complex sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i)
      sum += a[i] * (a[i] + b[i] * std::pow(s, alpha - 1.0)) / (s * s + k[i]);
    return sum;
  }
  // The zero near s, by Newton's method with differences.
  [[nodiscard]] Complex mode_near(Complex s) const {
    for (int i = 0; i < 30; ++i) {
      const Complex slope = (characteristic(s + 1e-6) - characteristic(s - 1e-6)) / 2e-6;
      s -= characteristic(s) / slope;
    }
    return s;
  }
  [[nodiscard]] Scene scene(const std::string& formulation = "integrated",
                            const ParameterValue& constant = std::string("a1*v1+a2*v2")) const {
    return scene_of("fractional_constraint_2d", {{"alpha", alpha},
                                                 {"a1", a[0]},
                                                 {"a2", a[1]},
                                                 {"b1", b[0]},
                                                 {"b2", b[1]},
                                                 {"k1", k[0]},
                                                 {"k2", k[1]},
                                                 {"C0", constant},
                                                 {"formulation", formulation}});
  }
};

// x(2h) - 2 Re(e^(sh)) x(h) + |e^(sh)|^2 x(0), which is 0 for x = Re(A e^(st)), divided by the size of its
// terms.
double mode_residual(const std::array<double, 3>& x, double h, Complex s) {
  const Complex factor = std::exp(s * h);
  const std::array<double, 3> terms{x[2], -2.0 * factor.real() * x[1], std::norm(factor) * x[0]};
  return std::abs(terms[0] + terms[1] + terms[2]) / (std::abs(terms[0]) + std::abs(terms[2]));
}
double mode_residual(const reference::Reference& reference, double t, double h, Complex s) {
  const auto x = [&](double at) { return reference.at(at).value[0]; };
  return mode_residual({x(t), x(t + h), x(t + 2 * h)}, h, s);
}

TEST(Modes, ThePartOfBAcrossACountsWhereStiffnessesDiffer) {
  const Plane plane{1.5, {1.0, 1.0}, {1.5, -1.0}, {6.0, 1.0}};
  const Complex mode = plane.mode_near({0.5, 1.1});
  EXPECT_LT(std::abs(mode - Complex(0.53498315955529860, 1.1214565627167905)), 1e-12);
  EXPECT_LT(mode_residual(reference_of(plane.scene()), 30.0, 0.7, mode), 1e-6);
}

// The multiplier form has the same solution.
TEST(Modes, GrowInEveryForm) {
  const Plane plane{1.5, {1.0, 1.0}, {1.5, -1.0}, {6.0, 1.0}};
  const Complex mode = plane.mode_near({0.5, 1.1});
  for (const auto* formulation : {"integrated", "multiplier"}) {
    Scene scene = plane.scene(formulation);
    scene.problem.end = 20.0;
    const auto path = solve("product_trapezoidal", scene.problem, 4000);
    EXPECT_LT(mode_residual({path.y(0, 3600), path.y(0, 3800), path.y(0, 4000)}, 1.0, mode), 1e-3)
        << formulation;
  }
}

// For equal k the mode is s^(alpha-1) = -|a|^2 / a.b.
TEST(Modes, WithEqualStiffnessesTheSignOfTheAlignmentDecides) {
  const Plane growing{1.5, {1.0, 1.0}, {0.5, -1.5}, {2.0, 2.0}};
  const reference::Reference grows = reference_of(growing.scene());
  EXPECT_NEAR(std::log(grows.at(6.0).value[0] / grows.at(5.0).value[0]), 4.0, 1e-3);
  const Plane other{1.5, {1.0, 1.0}, {1.5, -1.0}, {2.0, 2.0}};
  for (const double t : {10.0, 100.0, 1000.0})
    EXPECT_LT(reference_of(other.scene()).at(t).value.head(2).cwiseAbs().maxCoeff(), 2.0 * t) << t;
}

// If no mode grows, a nonzero constant moves q along k^-1 a, like t above order 1 and like t^alpha below;
// with a zero constant b.v(0) does, like t^(2-alpha).
TEST(Modes, WhatIsNoModeMovesAlongTheConstraintLikeAPower) {
  const auto power = [](const Plane& plane, const ParameterValue& constant) {
    const reference::Reference reference = reference_of(plane.scene("integrated", constant));
    return std::log10(reference.at(1e6).value[0] / reference.at(1e5).value[0]);
  };
  const Plane above{1.5, {1.0, 1.0}, {1.5, -1.0}, {2.0, 2.0}}, below{0.6, {1.0, 1.0}, {0.5, 0.5}, {2.0, 2.0}};
  EXPECT_NEAR(power(above, 0.4), 1.0, 0.01);
  EXPECT_NEAR(power(above, 0.0), 0.5, 0.01);
  EXPECT_NEAR(power(below, std::string("a1*v1+a2*v2")), 0.6, 0.01);
}

TEST(Modes, OfTheDefaultSceneGrow) {
  const Plane plane{0.5, {1.0, 2.0}, {0.5, -0.3}, {1.0, 2.0}};
  const Complex mode = plane.mode_near({0.03, 1.1});
  EXPECT_LT(std::abs(mode - Complex(0.031110186638392912, 1.1274693707127523)), 1e-12);
  EXPECT_LT(mode_residual(reference_of(scene_of("fractional_constraint_2d")), 400.0, 0.7, mode), 1e-4);
}

}  // namespace
}  // namespace fde::bench
