// SPDX-License-Identifier: MIT
// References of problems with a discontinuous right-hand side.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/exact_values.hpp"

namespace fde::reference {
namespace {

using bench::expect_exact;

// 1 before the jump, 0 after it, and the mean value at the jump, as for schemes.
double before(double time, double t) { return t < time ? 1.0 : t > time ? 0.0 : 0.5; }

class JumpOfOrder : public testing::TestWithParam<double> {};

// D^g y = (t < 1) - y: r(t) - r(t - 1), r(t) = t^g E_{g,1+g}(-t^g).
TEST_P(JumpOfOrder, IsAnswered) {
  const double order = GetParam();
  const Problem problem{.components = {{order, std::vector<double>(order > 1.0 ? 2 : 1, 0.0)}},
                        .rhs = [](double t, In y, Out f) { f[0] = before(1.0, t) - y[0]; },
                        .end = 3.0,
                        .jump_times = {1.0}};
  const Reference reference = reference_solution(problem);
  const auto response = [&](double t) {
    return t <= 0.0 ? 0.0 : std::pow(t, order) * mittag_leffler(order, 1.0 + order, -std::pow(t, order));
  };
  for (const double t : {0.3, 1.0, 1.0001, 1.01, 1.3, 2.0, 3.0})
    expect_exact(reference, t, Vec::Constant(1, response(t) - response(t - 1.0)), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Orders, JumpOfOrder, testing::Values(0.3, 0.6, 1.0, 1.6),
                         [](const auto& test) { return std::to_string(std::lround(10 * test.param)); });

// y' = y^2 up to 1 and y' = -y^2 from there, y(0) = 1/2: 1 / (2 - t), then 1 / t.
TEST(JumpsReference, TurnsANonlinearEquation) {
  const Problem problem{
      .components = {{1.0, {0.5}}},
      .rhs = [](double t, In y, Out f) { f[0] = (2.0 * before(1.0, t) - 1.0) * y[0] * y[0]; },
      .end = 4.0,
      .jump_times = {1.0, 7.0}};
  const Reference reference = reference_solution(problem);
  for (const double t : {0.5, 1.0, 1.5, 4.0})
    expect_exact(reference, t, Vec::Constant(1, t < 1.0 ? 1.0 / (2.0 - t) : 1.0 / t), 1e-12);
}

// An algebraic row z = (t < 1) as the right-hand side of D^(1/2) y = z:
// y = 2 (sqrt(t) - sqrt(t - 1)) / sqrt(pi).
TEST(JumpsReference, TakesAlgebraicRowsThatJump) {
  const Problem problem{.components = {{0.5, {0.0}}, {0.0, {1.0}}},
                        .rhs = [](double t, In y, Out f) { f << y[1], y[1] - before(1.0, t); },
                        .end = 2.0,
                        .jump_times = {1.0}};
  const Reference reference = reference_solution(problem);
  for (const double t : {0.5, 1.5, 2.0}) {
    const double since = t > 1.0 ? std::sqrt(t - 1.0) : 0.0;
    const Vec exact = Vec{{2.0 * (std::sqrt(t) - since) / std::sqrt(std::acos(-1.0)), before(1.0, t)}};
    expect_exact(reference, t, exact, 1e-10);
  }
}

}  // namespace
}  // namespace fde::reference
