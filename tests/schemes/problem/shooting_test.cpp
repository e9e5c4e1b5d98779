// SPDX-License-Identifier: MIT
// Newton's method for unknown initial values, with y(end) from closed forms.

#include "fdebench/schemes/problem/shooting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fde::bench {
namespace {

constexpr Tolerance rounding{1e-16, 0.0};

// y' = v, v' = f(t, y, v) with y(0) = 0 and y(end) = last.
Problem with_slope(double end, double last, Derivatives derivatives = {}) {
  return {.components = {{1.0, {0.0}}, {1.0, {}}},
          .rhs = [](double, In, Out f) { f.setZero(); },
          .derivatives = std::move(derivatives),
          .end = end,
          .conditions = [=](In, In at_end, Out residual) { residual[0] = at_end[0] - last; }};
}

Vec state(double y, double v) { return Vec{{y, v}}; }

double slope(const Problem& problem) { return problem.components[1].initial.front(); }

// y'' = -y, so y = v(0) sin t: a run from 0, one for the derivative, one with the result.
TEST(Shooting, AnAffineProblemTakesOneStep) {
  int runs = 0;
  const EndOfRun run = [&](const Problem& complete) {
    ++runs;
    const double v = slope(complete);
    return state(v * std::sin(1.0), v * std::cos(1.0));
  };
  const auto found = find_missing_values(
      with_slope(1.0, 2.0, DenseLinearPart{Matrix{{0.0, 1.0}, {-1.0, 0.0}}}), run, rounding);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.values[0], 2.0 / std::sin(1.0), 1e-15);
  EXPECT_EQ(runs, 3);
}

// y' = v, v' = -2 v^2: y = log(1 + 2 v(0) t) / 2 blows up at t = -1 / (2 v(0)). Newton's step from 0 to
// y(1) = -2, v(0) = -2, is far beyond -1/2, where no run reaches the end; the solution is (e^-4 - 1) / 2.
TEST(Shooting, AStepToARunThatBlowsUpIsHalved) {
  int failed = 0;
  const EndOfRun run = [&](const Problem& complete) -> std::optional<Vec> {
    const double v = slope(complete);
    failed += 1.0 + 2.0 * v <= 0.0 ? 1 : 0;
    if (1.0 + 2.0 * v <= 0.0) return std::nullopt;
    return state(std::log1p(2.0 * v) / 2.0, v / (1.0 + 2.0 * v));
  };
  const auto found = find_missing_values(with_slope(1.0, -2.0), run, rounding);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.values[0], std::expm1(-4.0) / 2.0, 1e-14);
  EXPECT_GT(failed, 0);
}

// v(0)^2 + 1 = 0 has no root: the method ends where F is smallest, and says what is missed.
TEST(Shooting, NothingIsFoundWhereThereIsNothing) {
  const EndOfRun run = [](const Problem& complete) {
    const double v = slope(complete) - 0.7;
    return state(v * v + 1.0, 0.0);
  };
  const auto found = find_missing_values(with_slope(1.0, 0.0), run, rounding);
  EXPECT_FALSE(found.converged);
  EXPECT_NEAR(found.missed, 1.0, 0.05);
  const auto none = find_missing_values(
      with_slope(1.0, 0.0), [](const Problem&) { return std::nullopt; }, rounding);
  EXPECT_FALSE(none.converged);
  EXPECT_EQ(none.missed, std::numeric_limits<double>::infinity());
}

// Values of different sizes in two rows, and two derivatives of one: y = a e^t + b, z = c t + d t^2.
TEST(Shooting, SeveralValuesAreFoundTogether) {
  const Problem problem{.components = {{1.0, {}}, {2.0, {0.0}}, {1.0, {}}},
                        .rhs = [](double, In, Out f) { f.setZero(); },
                        .conditions =
                            [](In at_start, In at_end, Out residual) {
                              residual << at_end[0] - 1e6, at_end[1] - at_start[0], at_end[2] - 3.0;
                            }};
  const EndOfRun run = [](const Problem& complete) {
    const auto& rows = complete.components;
    const double a = rows[0].initial[0], c = rows[1].initial[1], d = rows[2].initial[0];
    return Vec{{a * a * a + a, c + a * d, d * d + d}};
  };
  const auto found = find_missing_values(problem, run, rounding);
  ASSERT_TRUE(found.converged);
  const double a = found.values[0], c = found.values[1], d = found.values[2];
  EXPECT_NEAR(a * a * a + a, 1e6, 1e-8);
  EXPECT_NEAR(c + a * d, a, 1e-8);
  EXPECT_NEAR(d * d + d, 3.0, 1e-8);
}

// y'' = -k^2 y, y(0) = 0, y(1) = 1: at k = pi only the error of a discretisation makes F depend on v(0).
TEST(Shooting, ADerivativeThatIsAllErrorDeterminesNothing) {
  const auto run_with = [](double k, double error) {
    return [=](const Problem& complete) {
      const double v = slope(complete);
      return state(v * (std::sin(k) / k + error), v * std::cos(k));
    };
  };
  const auto is_determined = [&](double k) {
    const Problem problem = with_slope(1.0, 1.0);
    const auto found = find_missing_values(problem, run_with(k, 1e-4), rounding);
    EXPECT_TRUE(found.converged);
    return are_determined(problem, found, run_with(k, 2.5e-5));
  };
  EXPECT_TRUE(is_determined(3.0));
  EXPECT_FALSE(is_determined(std::numbers::pi));
}

}  // namespace
}  // namespace fde::bench
