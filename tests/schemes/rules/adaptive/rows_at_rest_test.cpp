// SPDX-License-Identifier: MIT
// Rows that are 0 but for rounding, and rows that are 0 until a load begins.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class RowAtRest : public testing::TestWithParam<const Scheme*> {
 protected:
  static Trajectory run(const Problem& problem, double accuracy) {
    return GetParam()->solve(problem, Tolerance{accuracy, accuracy}, {.budget = 5.0});
  }
};

// Solves a problem whose last row is 0, and the same without this row: both take about as many steps.
void expect_no_extra_steps(const Problem& whole, const std::function<Trajectory(const Problem&)>& run) {
  Problem rest = whole;
  rest.components.pop_back();
  rest.derivatives = NoDerivatives{};
  rest.rhs = [size = whole.size(), rhs = whole.rhs](double t, In y, Out f) {
    Vec all = Vec::Zero(size), values(size);
    all.head(size - 1) = y;
    rhs(t, all, values);
    f = values.head(size - 1);
  };
  const auto path = run(whole), alone = run(rest);
  ASSERT_EQ(path.status, SolveStatus::finished) << path.last_time;
  EXPECT_LT(path.steps + path.cost.rejected_steps.value_or(0),
            1.5 * static_cast<double>(alone.steps) + 100.0);
}

// D^0.6 w = 0.7 y + 0.1 y - 0.8 y.
TEST_P(RowAtRest, IsASumThatCancels) {
  const Problem problem{.components = {{0.8, {1.0}}, {0.6, {0.0}}},
                        .rhs = [](double, In y, Out f) { f << -y[0], 0.7 * y[0] + 0.1 * y[0] - 0.8 * y[0]; },
                        .derivatives = DenseJacobian{[](double, In, OutMatrix slopes) {
                          slopes.setZero();
                          slopes(0, 0) = -1.0;
                        }},
                        .end = 20.0};
  for (const double accuracy : {1e-3, 1e-6}) {
    expect_no_extra_steps(problem, [&](const Problem& of) { return run(of, accuracy); });
    EXPECT_LT(run(problem, accuracy).y.row(1).cwiseAbs().maxCoeff(), 1e-14);
  }
}

// S + I + R = 1 in an epidemic, a linear invariant, which every scheme keeps to rounding.
TEST_P(RowAtRest, IsTheDefectOfALinearInvariant) {
  const Problem problem{.components = {{0.9, {0.97}}, {0.9, {0.03}}, {0.9, {0.0}}, {0.5, {0.0}}},
                        .rhs =
                            [](double, In y, Out f) {
                              f << -0.7 * y[0] * y[1], 0.7 * y[0] * y[1] - 0.2 * y[1], 0.2 * y[1],
                                  1.0 - y[0] - y[1] - y[2];
                            },
                        .end = 30.0};
  for (const double accuracy : {1e-3, 1e-6}) {
    expect_no_extra_steps(problem, [&](const Problem& of) { return run(of, accuracy); });
    EXPECT_LT(run(problem, accuracy).y.row(3).cwiseAbs().maxCoeff(), 1e-11);
  }
}

// x^2 + v^2 = 1 of an oscillator, which the schemes keep to the accuracy: the row is as small as their
// errors.
TEST_P(RowAtRest, IsTheDefectOfAQuadraticInvariant) {
  const Problem problem{
      .components = {{1.0, {0.6}}, {1.0, {0.8}}, {0.7, {0.0}}},
      .rhs = [](double, In y, Out f) { f << 1.5 * y[1], -1.5 * y[0], 1.0 - y[0] * y[0] - y[1] * y[1]; },
      .end = 10.0};
  for (const double accuracy : {1e-3, 1e-5}) {
    expect_no_extra_steps(problem, [&](const Problem& of) { return run(of, accuracy); });
    EXPECT_LT(run(problem, accuracy).y.row(2).cwiseAbs().maxCoeff(), 100.0 * accuracy);
  }
}

// D^0.5 x = (t - 2) - x from t = 2 on, before it 0: x = s^1.5 E_{0.5,2.5}(-s^0.5), s = t - 2. The row has no
// size at the jump that its error could be compared with.
TEST_P(RowAtRest, StartsWhereALoadBegins) {
  const Problem problem{.components = {{0.5, {0.0}}},
                        .rhs = [](double t, In y, Out f) { f[0] = std::max(t - 2.0, 0.0) - y[0]; },
                        .end = 5.0,
                        .jump_times = {2.0}};
  for (const double accuracy : {1e-3, 1e-6}) {
    const auto path = run(problem, accuracy);
    ASSERT_EQ(path.status, SolveStatus::finished) << path.last_time;
    const auto exact = [](double t) {
      const double s = std::max(t - 2.0, 0.0);
      return std::pow(s, 1.5) * reference::mittag_leffler(0.5, 2.5, -std::sqrt(s));
    };
    expect_row(path, 0, exact, 3.0 * accuracy, 50);
  }
}

// The same for an oscillator, as rows x' = v and v' = load - x, and with a state that has decayed to 1e-60.
TEST_P(RowAtRest, StartsAgainWhereItHasDecayed) {
  const Problem problem{.components = {{1.0, {0.0}}, {1.0, {0.0}}, {1.0, {1.0}}},
                        .rhs =
                            [](double t, In y, Out f) {
                              const double load = std::max(t - 3.0, 0.0);
                              f << y[1], load - y[0], load - 50.0 * y[2];
                            },
                        .end = 6.0,
                        .jump_times = {3.0}};
  const auto path = run(problem, 1e-5);
  ASSERT_EQ(path.status, SolveStatus::finished) << path.last_time;
  const Vec y = path.y.rightCols<1>();
  EXPECT_NEAR(y[0], 3.0 - std::sin(3.0), 1e-4);
  EXPECT_NEAR(y[1], 1.0 - std::cos(3.0), 1e-4);
  EXPECT_NEAR(y[2], 3.0 / 50.0 - 1.0 / 2500.0, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Schemes, RowAtRest, testing::ValuesIn(adaptive_schemes()), id_of_param);

}  // namespace
}  // namespace fde::bench
