// SPDX-License-Identifier: MIT
// Algebraic rows that constrain other unknowns than their own (index 2): a fractional constraint with a
// multiplier against the form from which the multiplier has been eliminated by hand.

#include <gtest/gtest.h>

#include "support/algebraic_problems.hpp"
#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class Multiplier : public SchemeTest {
 protected:
  static double largest(const Rows& rows) { return rows.cwiseAbs().maxCoeff(); }
};

INSTANTIATE_TEST_SUITE_P(, Multiplier, testing::ValuesIn(implicit_schemes()), id_of_param);

TEST_P(Multiplier, EqualsTheIntegratedForm) {
  for (const double alpha : {0.3, 0.5, 0.8}) {
    for (const Eigen::Vector2d& velocity : {Eigen::Vector2d{0.0, 0.0}, Eigen::Vector2d{-0.4, 0.7}}) {
      const AlgebraicPlane plane{.alpha = alpha, .velocity = velocity};
      for (const Grid& grid : grids_of(*GetParam(), plane.end, 1000)) {
        const Rows free = values(plane.integrated(), grid), y = values(plane.multiplier(0.0), grid);
        const Rows z =
            y.middleRows(2, 2) + plane.a * (plane.b.transpose() * y.middleRows(4, 2)) / plane.a.squaredNorm();
        EXPECT_LT(largest(y.topRows(2) - free.topRows(2)), 1e-12) << alpha << ' ' << grid.grading;
        EXPECT_LT(largest(z - free.middleRows(2, 2)), 1e-12) << alpha << ' ' << grid.grading;
        EXPECT_LT(largest(y.middleRows(4, 2) - free.bottomRows(2)), 1e-12) << alpha << ' ' << grid.grading;
      }
    }
  }
}

TEST_P(Multiplier, HoldsALinearConstraintToRounding) {
  const AlgebraicPlane plane;
  for (int steps = 64; steps <= 4096; steps *= 8) {
    for (const Grid& grid : grids_of(*GetParam(), plane.end, steps)) {
      const Rows y = values(plane.multiplier(0.0), grid);
      const Rows drift = plane.a.transpose() * (y.middleRows(2, 2).colwise() - plane.velocity) +
                         plane.b.transpose() * y.middleRows(4, 2);
      EXPECT_LT(largest(drift), 2e-15) << steps;
    }
  }
}

// Steps down to 1e-9: the Newton matrix has entries of the size of h.
TEST_P(Multiplier, IsAsAccurateForShortSteps) {
  for (const double h : {1e-3, 1e-6, 1e-9}) {
    const AlgebraicPlane plane{.alpha = 0.7, .end = 64 * h};
    const Rows free = values(plane.integrated(), {plane.end, 64}),
               y = values(plane.multiplier(0.0), {plane.end, 64});
    EXPECT_LT(largest(y.topRows(2) - free.topRows(2)), 2e-15) << h;
    EXPECT_LT(largest(y.middleRows(4, 2) - free.bottomRows(2)), 2e-15) << h;
  }
}

TEST_P(Multiplier, ALinearPartAndDifferencesGiveTheSameAnswer) {
  Problem problem = AlgebraicPlane{}.multiplier(0.0);
  const Rows linear = values(problem, {2.0, 200});
  problem.derivatives = NoDerivatives{};
  const Rows differenced = values(problem, {2.0, 200});
  EXPECT_LT(largest((linear - differenced).topRows(6)), 1e-13);
  EXPECT_LT(largest((linear - differenced).row(6)), 1e-13 * 200);  // rounding / h
}

TEST_P(Multiplier, TheUnitsOfARowDoNotMatter) {
  Matrix linear = AlgebraicPlane{}.linear_part();
  linear(6, 0) = 1e-9;  // small, but in other units the largest number of its column
  const auto in_unit = [&](double unit) {
    Problem problem = AlgebraicPlane{}.multiplier(0.0);
    Matrix a = linear;
    a.row(6) *= unit;
    problem.derivatives = DenseLinearPart{a};
    problem.rhs = [unit, a](double, In y, Out f) {
      f = a * y;
      f[6] -= unit;  // a.v + b.w + 1e-9 q_1 = 1 at t = 0, up to 1e-9
    };
    return problem;
  };
  const Rows once = values(in_unit(1.0), {2.0, 200});
  for (const double unit : {1e-9, 1e12}) {
    Problem scaled = in_unit(unit);
    EXPECT_LT(largest((values(scaled, {2.0, 200}) - once).topRows(6)), 1e-14) << unit;
    scaled.derivatives = NoDerivatives{};
    EXPECT_LT(largest((values(scaled, {2.0, 200}) - once).topRows(6)), 1e-13) << unit;
  }
}

// a.v + b.w = 1 and three times the same row: redundant, or a contradiction.
TEST_P(Multiplier, DependentConstraintsAreAnOutcome) {
  const Problem once = AlgebraicPlane{}.multiplier(0.0);
  Matrix linear = Matrix::Zero(8, 8);
  linear.topLeftCorner(7, 7) = AlgebraicPlane{}.linear_part();
  linear.col(7) = 3.0 * linear.col(6);
  linear.row(7) = 3.0 * linear.row(6);
  for (const double second : {3.0, 4.0}) {
    Problem twice{.components = once.components,
                  .rhs =
                      [=](double, In y, Out f) {
                        f = linear * y;
                        f[6] -= 1.0;
                        f[7] -= second;
                      },
                  .derivatives = DenseLinearPart{linear}};
    twice.components.push_back({0.0, {0.0}});
    for (int steps = 100; steps < 120; ++steps) {
      EXPECT_NE(GetParam()->solve(twice, Grid{2.0, steps}, {}).status, SolveStatus::finished);
    }
    twice.derivatives = NoDerivatives{};
    if (second == 3.0) continue;  // Newton's method may find one of the many multipliers
    for (int steps = 100; steps < 120; ++steps) {
      EXPECT_NE(GetParam()->solve(twice, Grid{2.0, steps}, {}).status, SolveStatus::finished);
    }
  }
}

TEST_P(Multiplier, HistoriesAgree) {
  for (const Grid& grid : grids_of(*GetParam(), 2.0, 400)) {
    const Problem problem = AlgebraicPlane{}.multiplier(0.0);
    const Rows direct = values(problem, grid, {.history = HistoryKind::direct});
    const Rows exponentials = values(problem, grid, {.history = HistoryKind::exponentials});
    EXPECT_LT(largest((direct - exponentials).topRows(6)), 1e-13);
  }
}

// lambda(0) is a guess: the solution, including lambda at later times, does not depend on it.
TEST_P(Multiplier, AWrongInitialValueOfItChangesNothing) {
  for (const Grid& grid : grids_of(*GetParam(), 2.0, 300)) {
    const Rows right = values(AlgebraicPlane{}.multiplier(0.0), grid),
               wrong = values(AlgebraicPlane{}.multiplier(1.0), grid);
    EXPECT_LT(largest((right - wrong).topRows(6)), 1e-12) << grid.grading;
    EXPECT_LT(largest((right - wrong).row(6).rightCols(300)), 1e-9) << grid.grading;
  }
}

}  // namespace
}  // namespace fde::bench
