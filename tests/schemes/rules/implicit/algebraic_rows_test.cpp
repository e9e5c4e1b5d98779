// SPDX-License-Identifier: MIT
// Rows 0 = f_i(t, y) that determine their own unknown (index 1) in every implicit scheme.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "support/algebraic_problems.hpp"
#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class AlgebraicRows : public SchemeTest {};
INSTANTIATE_TEST_SUITE_P(, AlgebraicRows, testing::ValuesIn(implicit_schemes()), id_of_param);

TEST_P(AlgebraicRows, AnUnknownThatCanBeEliminatedChangesNothing) {
  const Matrix a = (Matrix(2, 2) << 4.0, -4.0, -1.0, 0.0).finished();
  for (const double order : {0.3, 0.5, 1.0, 1.5, 2.0}) {
    for (const Grid& grid : grids_of(*GetParam(), 2.0, 300)) {
      auto problem = decay_through(order);
      const Rows alone = run(decay(order), grid).y, newton = run(problem, grid).y;
      problem.derivatives = DenseLinearPart{a};
      const Rows linear = run(problem, grid).y;
      for (const Rows& both : {newton, linear}) {
        EXPECT_LT((both.row(1) - alone).cwiseAbs().maxCoeff(), 1e-14) << order;
        EXPECT_LT((both.row(0) - alone).cwiseAbs().maxCoeff(), 1e-14) << order;
      }
    }
  }
}

TEST_P(AlgebraicRows, HaveNoPast) {
  for (const Grid& grid : grids_of(*GetParam(), 2.0, 200)) {
    for (const auto kind : {HistoryKind::direct, HistoryKind::exponentials}) {
      const Options options{.history = kind};
      EXPECT_EQ(run(decay_through(0.5), grid, options).cost.history_bytes,
                run(decay(0.5), grid, options).cost.history_bytes);
    }
  }
}

TEST_P(AlgebraicRows, MayBeAlone) {
  const Problem cube_root{.components = {{0.0, {1.0}}},
                          .rhs = [](double t, In y, Out f) { f[0] = y[0] * y[0] * y[0] - 1.0 - t; }};
  for (const Grid& grid : grids_of(*GetParam(), 1.0, 150)) {
    const auto path = run(cube_root, grid);
    for (int n = 0; n <= grid.steps; ++n)
      EXPECT_NEAR(path.y(0, n), std::cbrt(1.0 + grid.time(n)), 1e-15) << n;
  }
}

// y = t^2, z = 1 + t: D^0.6 y = Gamma(3)/Gamma(2.4) t^1.4 + 1 + t - z, 0 = z^2 - y - 1 - 2 t.
TEST_P(AlgebraicRows, LeaveTheRateAsItIs) {
  const Problem problem{.components = {{0.6, {0.0}}, {0.0, {1.0}}}, .rhs = [](double t, In y, Out f) {
                          f[0] = 2.0 / std::tgamma(2.4) * std::pow(t, 1.4) + 1.0 + t - y[1];
                          f[1] = y[1] * y[1] - y[0] - 1.0 - 2.0 * t;
                        }};
  const Smoothness smoothness{.powers = {{2.0}, {}}, .breaking_points = {{1, 0.0}}};
  const auto theory = [&](Norm norm) { return GetParam()->expected_rate(problem, smoothness, 1.0, norm); };
  std::vector<ErrorSample> of_y, of_z;
  for (int steps = 128; steps <= 2048; steps *= 2) {
    const auto path = run(problem, {1.0, steps});
    of_y.push_back({1.0 / steps, std::abs(path.y(0, steps) - 1.0)});
    of_z.push_back({1.0 / steps, std::abs(path.y(1, steps) - 2.0)});
  }
  EXPECT_GE(theory(Norm::end), 1.0);
  EXPECT_EQ(theory(Norm::maximum), theory(Norm::end));
  EXPECT_NEAR(fit_rate(of_y).slope, theory(Norm::end), 0.1);
  EXPECT_NEAR(fit_rate(of_z).slope, theory(Norm::end), 0.1);
}

TEST_P(AlgebraicRows, AnImpossibleOneIsAnOutcome) {
  for (const double slope : {0.0, 1.0}) {  // 0 = 1, 0 = 1 + z^2
    const Problem problem{.components = {{0.5, {1.0}}, {0.0, {0.5}}},
                          .rhs = [=](double, In y, Out f) { f << -y[0], 1.0 + slope * y[1] * y[1]; }};
    const auto path = run(problem, {1.0, 8});
    EXPECT_NE(path.status, SolveStatus::finished);
    EXPECT_EQ(path.last_time, 0.0);
  }
}

TEST_P(AlgebraicRows, NeedOneInitialValue) {
  auto problem = decay_through(0.5);
  problem.components[0].initial = {};
  EXPECT_EQ(unsupported_reason(*GetParam(), problem, Grid{2.0, 8}),
            "needs 1 initial value for order 0, component 0 has 0");
  problem.components[0] = {-0.5, {1.0}};
  EXPECT_EQ(unsupported_reason(*GetParam(), problem, Grid{2.0, 8}),
            "takes orders in [0, 2], component 0 has -0.5");
}

}  // namespace
}  // namespace fde::bench
