// SPDX-License-Identifier: MIT
// Unknown initial values with conditions at both ends, and refusals of two-sided problems.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using std::numbers::pi;

// y'' = -y, y(0) = 0, y(pi/2) = 1: y = sin t. The unknown slope is 1.
Problem sine() {
  return {.components = {{2.0, {0.0}}},
          .rhs = [](double, In y, Out f) { f = -y; },
          .end = pi / 2,
          .conditions = [](In, In at_end, Out residual) { residual[0] = at_end[0] - 1.0; }};
}

double error_of_sine(int steps) {
  const auto path = solve("product_trapezoidal", sine(), steps);
  EXPECT_EQ(path.status, SolveStatus::finished);
  double error = 0.0;
  for (int n = 0; n <= steps; ++n) error = std::max(error, std::abs(path.y(0, n) - std::sin(path.time(n))));
  return error;
}

TEST(Conditions, AMissingSlopeIsFound) {
  EXPECT_LT(error_of_sine(1000), 1e-6);
  EXPECT_NEAR(error_of_sine(500) / error_of_sine(1000), 4.0, 0.1);
}

// D^1.5 y = Gamma(3.5) t with y = t^2.5 + t: f is linear, so the trapezoidal rule is exact.
TEST(Conditions, WhatTheRuleIntegratesExactlyIsExact) {
  const Problem problem{
      .components = {{1.5, {0.0}}},
      .rhs = [](double t, In, Out f) { f[0] = std::tgamma(3.5) * t; },
      .end = 2.0,
      .conditions = [](In, In at_end,
                       Out residual) { residual[0] = at_end[0] - (std::pow(2.0, 2.5) + 2.0); }};
  const auto path = solve("product_trapezoidal", problem, 64);
  for (int n = 0; n <= 64; ++n) {
    const double t = path.time(n);
    EXPECT_NEAR(path.y(0, n), std::pow(t, 2.5) + t, 1e-13);
  }
}

// Bratu: y'' = -2 e^y, y(0) = y(1) = 0. The lower solution is -2 ln(cosh((x - 1/2) a / 2) / cosh(a / 4)) with
// a = sqrt(4) cosh(a / 4) (Ascher, Mattheij & Russell 1988, example 3.2): a = 2.3575510538774.
TEST(Conditions, ANonlinearBoundaryValueProblem) {
  double a = 2.0;
  for (int k = 0; k < 200; ++k) a = 2.0 * std::cosh(a / 4);
  const Problem problem{.components = {{1.0, {0.0}}, {1.0, {}}},
                        .rhs = [](double, In y, Out f) { f << y[1], -2.0 * std::exp(y[0]); },
                        .conditions = [](In, In at_end, Out residual) { residual[0] = at_end[0]; }};
  const auto path = solve("product_trapezoidal", problem, 2048);
  ASSERT_EQ(path.status, SolveStatus::finished);
  for (const int n : {512, 1024, 1536}) {
    const double x = path.time(n);
    EXPECT_NEAR(path.y(0, n), -2.0 * std::log(std::cosh((x - 0.5) * a / 2) / std::cosh(a / 4)), 1e-7);
  }
}

// The minimum of 1/2 int u^2 with y' = u, y(0) = 0, y(4) = 1: u = 1/4, from the adjoint equation u' = 0. The
// constant is an unknown of order 1, with a left or a right derivative.
TEST(Conditions, AnUnknownConstant) {
  for (const auto side : {Side::left, Side::right}) {
    const Problem problem{.components = {{1.0, {0.0}}, {1.0, {}, side}},
                          .rhs = [](double, In y, Out f) { f << y[1], 0.0; },
                          .end = 4.0,
                          .conditions = [](In, In at_end, Out residual) { residual[0] = at_end[0] - 1.0; }};
    for (const auto* scheme : {"product_trapezoidal", "grunwald_letnikov"}) {
      const auto path = solve(scheme, problem, 200);
      ASSERT_EQ(path.status, SolveStatus::finished);
      EXPECT_LT((path.y.row(1).array() - 0.25).abs().maxCoeff(), 1e-14);
      EXPECT_NEAR(path.y(0, 100), 0.5, 1e-14);
    }
  }
}

// y' = -p, and -p' = y from the right, p(T) = y(T): the linear regulator with unit weights, p = y = e^-t.
// Over 60 units of time no side may be stepped with the growing mode e^t.
TEST(Conditions, ARegulatorOverALongTime) {
  const Problem problem{
      .components = {{1.0, {1.0}}, {1.0, {}, Side::right}},
      .rhs = [](double, In y, Out f) { f << -y[1], y[0]; },
      .end = 60.0,
      .conditions = [](In, In at_end, Out residual) { residual[0] = at_end[1] - at_end[0]; }};
  const auto path = solve("product_trapezoidal", problem, 6000);
  ASSERT_EQ(path.status, SolveStatus::finished);
  for (const int n : {100, 500, 1000}) {
    EXPECT_NEAR(path.y(0, n), std::exp(-path.time(n)), 1e-5);
    EXPECT_NEAR(path.y(1, n), std::exp(-path.time(n)), 1e-5);
  }
}

TEST(Conditions, AGradedGridServesLeftRows) {
  const auto path = solve("product_trapezoidal", sine(), Grid{pi / 2, 400, 2.0});
  ASSERT_EQ(path.status, SolveStatus::finished);
  for (const int n : {100, 200, 300}) EXPECT_NEAR(path.y(0, n), std::sin(path.time(n)), 1e-5);
}

TEST(Refusal, TwoSidedProblems) {
  const auto refuses = [](const char* scheme, const Problem& problem, const Grid& grid) {
    return unsupported_reason(*find_scheme(scheme), problem, grid).value_or("accepted");
  };
  const auto rhs = [](double, In, Out f) { f.setZero(); };
  const Problem right{.components = {{1.0, {0.0}}, {0.5, {0.0}, Side::right}}, .rhs = rhs, .end = 2.0};
  for (const auto* steps : {"adams_pc", "l1", "decoupled_multi_order", "commensurate_adams_pc"}) {
    EXPECT_EQ(refuses(steps, right, {2.0, 8}), "steps from the left: component 1 has a right derivative");
    EXPECT_EQ(refuses(steps, sine(), {pi / 2, 8}), "accepted");
  }
  EXPECT_EQ(refuses("product_trapezoidal", right, {2.0, 8}), "accepted");
  EXPECT_EQ(refuses("product_trapezoidal", right, {2.0, 8, 1.5}),
            "needs a uniform grid for the right derivative of component 1");
  EXPECT_EQ(refuses("product_trapezoidal", right, {1.0, 8}),
            "needs a grid that ends with the problem, at 2 and not 1");
  Problem complete = sine();
  complete.components = {{2.0, {0.0, 1.0}}};
  EXPECT_EQ(refuses("product_trapezoidal", complete, {pi / 2, 8}),
            "needs an unknown initial value for each condition, none is unknown");
  complete.components = {{0.5, {0.0, 1.0}}};
  EXPECT_EQ(refuses("product_trapezoidal", complete, {pi / 2, 8}),
            "needs 1 initial value for order 0.5, component 0 has 2");
  Problem open = right;
  open.components[1].initial.clear();
  EXPECT_EQ(refuses("product_trapezoidal", open, {2.0, 8}),
            "needs 1 initial value for order 0.5, component 1 has 0");
}

TEST(Refusal, ReferencesAndSeriesOfRightRows) {
  const std::vector<Component> components{{0.5, {1.0}, Side::right}};
  EXPECT_THROW(linear_smoothness(components, -Matrix::Ones(1, 1)), std::invalid_argument);
  const Problem problem{.components = components, .rhs = [](double, In y, Out f) { f = -y; }};
  EXPECT_THROW(reference::reference_table(problem), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
