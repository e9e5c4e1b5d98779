// SPDX-License-Identifier: MIT
// Which unknowns are multipliers, the index of their constraints, and the accuracy of the trapezoidal rule.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"
#include "support/algebraic_problems.hpp"
#include "support/implicit_schemes.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

using testing::Optional;

// x' = v, v' = -v + lambda and the constraint that x, v or a memory of order 1 - alpha of v is sin t.
struct Driven {
  enum Constrained { position, velocity, memory };
  Constrained constrained = velocity;
  double memory_order = 0.5;

  [[nodiscard]] Problem problem(double initial_multiplier = 0.0) const {
    const Eigen::Index row = constrained;
    return {.components = {{1.0, {0.0}}, {1.0, {0.0}}, {memory_order, {0.0}}, {0.0, {initial_multiplier}}},
            .rhs = [row](double t, In y, Out f) {
              f.head<4>() << y[1], -y[1] + y[3], y[1], y[row] - std::sin(t);
            }};
  }
};

TEST(Multipliers, AreTheUnknownsThatNoAlgebraicRowHolds) {
  EXPECT_THAT(multipliers(AlgebraicPlane{}.multiplier(0.0)), ElementsAre(6));
  EXPECT_THAT(multipliers(AlgebraicPlane{}.integrated()), IsEmpty());
  EXPECT_THAT(multipliers(decay_through(0.5)), IsEmpty());
  // 0 = z^2 - y, whose derivative is 0 at the start, z = 0.
  const Problem square{.components = {{0.5, {0.0}}, {0.0, {0.0}}},
                       .rhs = [](double, In y, Out f) { f << 1.0 - y[1], y[1] * y[1] - y[0]; }};
  EXPECT_THAT(multipliers(square), IsEmpty());
  // 0 = sin(t) (z - y), which holds for any y, z at the start.
  const Problem late{.components = {{1.0, {1.0}}, {0.0, {1.0}}},
                     .rhs = [](double t, In y, Out f) { f << -y[1], std::sin(t) * (y[1] - y[0]); },
                     .end = 1.0};
  EXPECT_THAT(multipliers(late), IsEmpty());
}

TEST(Multipliers, AreAsManyOrdersFromTheirConstraintAsTheRowsBetweenIntegrate) {
  EXPECT_NEAR(multiplier_integration_order(Driven{Driven::velocity}.problem()), 1.0, 1e-3);
  EXPECT_NEAR(multiplier_integration_order(Driven{Driven::position}.problem()), 2.0, 1e-3);
  EXPECT_NEAR(multiplier_integration_order(Driven{Driven::memory, 0.4}.problem()), 1.4, 1e-3);
  EXPECT_NEAR(multiplier_integration_order(AlgebraicPlane{}.multiplier(0.0)), 1.0, 1e-3);
}

TEST(Multipliers, FarFromTheirConstraintAreRefusedByTheTrapezoidalRule) {
  const auto reason = [](const Problem& problem) {
    return unsupported_reason(*find_scheme("product_trapezoidal"), problem, Grid{1.0, 8});
  };
  EXPECT_EQ(reason(Driven{Driven::velocity}.problem()), std::nullopt);
  EXPECT_EQ(reason(Driven{Driven::position}.problem()),
            "takes constraints that are one integration away from their multipliers (index 2), not 2");
  EXPECT_THAT(reason(Driven{Driven::memory, 0.4}.problem()), Optional(HasSubstr("(index 2), not 1.4")));
  Problem five = Driven{}.problem();  // x' = v, v' = u, u' = w, w' = lambda, x given
  five.components = {{1.0, {0.0}}, {1.0, {0.0}}, {1.0, {0.0}}, {1.0, {0.0}}, {0.0, {0.0}}};
  five.rhs = [](double t, In y, Out f) { f << y[1], y[2], y[3], y[4], y[0] - std::sin(t); };
  EXPECT_THAT(reason(five), Optional(HasSubstr("(index 2), not 4")));
  const Problem above_one{.components = {{1.5, {0.0, 0.0}}, {1.0, {0.0}}, {0.0, {0.0}}},
                          .rhs = [](double t, In y, Out f) { f << y[2], y[2], y[1] - std::sin(t); }};
  EXPECT_EQ(reason(above_one), "takes no multiplier in a row of order above 1: component 2 is in that of 0");
  Problem at_both_ends = Driven{}.problem();
  at_both_ends.components.push_back({1.0, {0.0}, Side::right});
  EXPECT_EQ(reason(at_both_ends), "takes multipliers in steps from the left only: component 3 is one");
}

class UnknownMultipliers : public testing::TestWithParam<const Scheme*> {
 protected:
  [[nodiscard]] static bool trapezoidal() { return GetParam()->id == "product_trapezoidal"; }

  // The rate of the error off(y) at the end.
  template <class Off>
  static double rate(const Problem& problem, double grading, Off off) {
    std::vector<ErrorSample> errors;
    for (int steps = 128; steps <= 2048; steps *= 2) {
      const Trajectory path = GetParam()->solve(problem, Grid{problem.end, steps, grading}, {});
      EXPECT_EQ(path.status, SolveStatus::finished);
      errors.push_back({1.0 / steps, std::abs(off(path.y.col(steps)))});
    }
    return fit_rate(errors).slope;
  }
};

INSTANTIATE_TEST_SUITE_P(, UnknownMultipliers, testing::ValuesIn(implicit_schemes()), id_of_param);

// v = sin t, so lambda = cos t + sin t, whatever lambda(0) is.
TEST_P(UnknownMultipliers, AreKnownAtTheTimesOfTheGrid) {
  const double lambda = std::cos(1.0) + std::sin(1.0);
  for (const double wrong : {0.0, 5.0}) {
    for (const Grid& grid : grids_of(*GetParam(), 1.0, 1)) {
      const double found =
          rate(Driven{}.problem(wrong), grid.grading, [=](const Vec& y) { return y[3] - lambda; });
      EXPECT_NEAR(found, trapezoidal() ? 2.0 : 1.0, 0.1) << wrong << ' ' << grid.grading;
    }
  }
}

// The same lambda in D^0.6 u = -u + lambda: u is as if lambda were given.
TEST_P(UnknownMultipliers, DriveRowsOfOrderBelowOne) {
  const double order = 0.6;
  const Problem with_unknown{
      .components = {{1.0, {0.0}}, {order, {0.0}}, {0.0, {3.0}}},
      .rhs = [](double t, In y, Out f) { f << -y[0] + y[2], -y[1] + y[2], y[0] - std::sin(t); }};
  const Problem given{.components = {{order, {0.0}}},
                      .rhs = [](double t, In y, Out f) { f[0] = -y[0] + std::cos(t) + std::sin(t); }};
  const double exact =
      find_scheme("product_trapezoidal")->solve(given, Grid{1.0, 20000, 2.0}, {}).y(0, 20000);
  for (const Grid& grid : grids_of(*GetParam(), 1.0, 1)) {
    const double found = rate(with_unknown, grid.grading, [=](const Vec& y) { return y[1] - exact; });
    EXPECT_GT(found, trapezoidal() ? 1.5 : 0.9) << grid.grading;
  }
}

TEST_P(UnknownMultipliers, AreCountedInWhatTheyCost) {
  std::int64_t calls = 0;
  Problem problem = Driven{}.problem();
  problem.rhs = [&calls, rhs = problem.rhs](double t, In y, Out f) {
    ++calls;
    rhs(t, y, f);
  };
  const auto path = GetParam()->solve(problem, Grid{1.0, 50}, {});
  EXPECT_EQ(path.cost.rhs_calls, calls);
}

}  // namespace
}  // namespace fde::bench
