// SPDX-License-Identifier: MIT
// A reference is believed by its residual: what no method samples, and a solution that does not continue
// y(0), is rejected or found.

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/reference/nonlinear/collocation.hpp"
#include "support/message_of.hpp"

namespace fde::reference {
namespace {

// D^g x = -x - 0.1 x^3 + 20 exp(-((t - 13.3)/width)^2), x(0) = 0.3.
Problem pulsed(double width, std::vector<StepLimit> limits) {
  constexpr double place = 13.3;
  Problem problem{.components = {{0.9, {0.3}}}, .end = 20.0, .step_limits = std::move(limits)};
  problem.rhs = [=](double t, In x, Out f) {
    f[0] = -x[0] - 0.1 * std::pow(x[0], 3) + 20.0 * std::exp(-std::pow((t - place) / width, 2));
  };
  problem.derivatives = DenseJacobian{[](double, In x, OutMatrix j) { j(0, 0) = -1.0 - 0.3 * x[0] * x[0]; }};
  problem.range = [=](const Interval& t, std::span<const Interval> x, std::span<Interval> f) {
    f[0] = -x[0] - 0.1 * pow(x[0], 3.0) + 20.0 * exp(-square((t - place) / width));
  };
  return problem;
}

TEST(Residual, RejectsASolutionThatPassesOverAPulse) {
  EXPECT_THROW(reference_solution(pulsed(0.01, {})), std::runtime_error);
}

// As for a function without a known range: points of each panel decide.
TEST(Residual, RejectsASolutionThatPassesOverAPulseOfUnknownRange) {
  Problem problem = pulsed(0.003, {});
  problem.range = [](const Interval&, std::span<const Interval>, std::span<Interval> f) {
    f[0] = Interval::all();
  };
  bench::expect_message<std::runtime_error>([&] { reference_solution(problem); }, "does not satisfy row 1");
}

// 0.300731291807: two resolutions of another collocation code.
TEST(Residual, IsSmallWhereStepsResolveThePulse) {
  const auto reference = reference_solution(pulsed(0.01, {{13.24, 13.3, 0.015}, {13.3, 13.36, 0.015}}));
  const auto [value, bound] = reference.at(13.5);
  EXPECT_NEAR(value[0], 0.300731291807, bound[0] + 5e-12);
  EXPECT_LE(bound[0], 1e-9);
}

// D^g y = -1000 y^2, y(0) = 2.5. J^g is nearly the multiplication by t^g/Gamma(1+g) for small g, so
// y + 1000 t^g/Gamma(1+g) y^2 is nearly y(0); its other root is negative. 0.0492125 at t = 1 comes from a
// trapezoidal rule on graded times down to 1e-300.
TEST(Residual, BelongsToTheRootThatContinuesTheInitialValue) {
  Problem problem{.components = {{0.02, {2.5}}}, .end = 1.0};
  problem.rhs = [](double, In y, Out f) { f[0] = -1000.0 * y[0] * y[0]; };
  problem.derivatives = DenseJacobian{[](double, In y, OutMatrix j) { j(0, 0) = -2000.0 * y[0]; }};
  problem.range = [](const Interval&, std::span<const Interval> y, std::span<Interval> f) {
    f[0] = -1000.0 * square(y[0]);
  };
  const auto [value, bound] = reference_solution(problem).at(1.0);
  EXPECT_NEAR(value[0], 0.0492125, 2e-6);
  EXPECT_LE(bound[0], 1e-6);
}

}  // namespace
}  // namespace fde::reference
