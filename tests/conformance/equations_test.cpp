// SPDX-License-Identifier: MIT
// Properties of every scheme that discretises the equations of a problem in place of its rows.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"
#include "fdebench/schemes/problem/chain.hpp"
#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class OnEquations : public SchemeTest {};
INSTANTIATE_TEST_SUITE_P(, OnEquations, testing::ValuesIn(equation_schemes()), id_of_param);

// Two coupled equations of different leading orders; the terms of the first have a factor, and the force of
// the second depends on a fractional derivative of the first.
Problem coupled() {
  const Chain first({2.0, 1.8}, {{0.4, 0.3}, {0.7, 1.1}}, {1.0, -0.5});
  const Chain second({1.0, 0.9}, {{0.5, 0.6}}, {0.25}, first.size());
  const auto u = first.first_row(), v = second.first_row(), fractional = *first.row(0.3);
  return chain_problem(
      {{.chain = first,
        .force = [=](double t, In y) { return std::cos(t) - std::sin(y[u]) + y[v]; },
        .factor = [=](double, In y) { return 1.0 + y[v] * y[v]; }},
       {.chain = second, .force = [=](double, In y) { return y[u] - 2.0 * y[v] + 0.3 * y[fractional]; }}},
      2.0);
}

TEST_P(OnEquations, ConstantsAreExact) {
  for (const double leading : {0.5, 1.0, 1.7, 2.0}) {
    std::vector<double> initial(initial_count(leading), 0.0);
    initial.front() = 3.25;
    const Chain chain({1.5, leading}, {{0.4, 0.2 * leading}, {-0.3, 0.7 * leading}}, initial);
    const auto path =
        run(chain_problem({{.chain = chain, .force = [](double, In) { return 0.0; }}}, 1.0), 50);
    EXPECT_EQ((path.y.row(0).array() - 3.25).abs().maxCoeff(), 0.0) << leading;
    EXPECT_EQ(path.y.bottomRows(chain.size() - 1).cwiseAbs().maxCoeff(), 0.0) << leading;
  }
}

// u = 1 - 3t/4 with terms of whole order and a linear force: the rules that interpolate g are exact.
TEST_P(OnEquations, ALineIsExactWhereItsForceIsALine) {
  if (GetParam()->id == "multi_term_grunwald_letnikov") return;
  const Chain chain({1.3, 2.0}, {{0.4, 0.0}, {0.5, 1.0}}, {1.0, -0.75});
  const auto force = [](double t, In) { return 0.4 * (1.0 - 0.75 * t) - 0.5 * 0.75; };
  for (const auto& grid : grids_of(*GetParam(), 1.0, 64)) {
    const auto path = run(chain_problem({{.chain = chain, .force = force}}, 1.0), grid);
    for (int n = 0; n <= 64; ++n) {
      EXPECT_NEAR(path.y(0, n), 1.0 - 0.75 * grid.time(n), 1e-14) << n;
      EXPECT_NEAR(path.y(1, n), -0.75, 1e-13) << n;
    }
  }
}

// Without terms an equation is a row: D^g u = f(t, u).
TEST_P(OnEquations, WithoutTermsTheRowSchemeIsLeft) {
  const auto rule = GetParam()->id.substr(std::string_view("multi_term_").size());
  const auto* row_scheme = find_scheme(rule == "trapezoidal" ? "product_trapezoidal" : rule);
  if (!GetParam()->capabilities.implicit) return;
  for (const double order : {0.4, 1.0, 1.6, 2.0}) {
    if (GetParam()->starting_powers && order > 1.0) continue;  // u' is a row with start powers of its own
    std::vector<double> initial{1.0, -0.3};
    initial.resize(initial_count(order));
    const auto force = [](double t, In y) { return std::cos(t) - y[0] * y[0] * y[0]; };
    const Problem row{.components = {{order, initial}},
                      .rhs = [=](double t, In y, Out f) { f[0] = force(t, y); },
                      .end = 2.0};
    const Chain chain({1.0, order}, {}, initial);
    for (const auto& grid : grids_of(*GetParam(), 2.0, 200)) {
      const auto of_row = row_scheme->solve(row, grid, {});
      const auto of_equation = run(chain_problem({{.chain = chain, .force = force}}, 2.0), grid);
      EXPECT_LT((of_row.y.row(0) - of_equation.y.row(0)).cwiseAbs().maxCoeff(), 1e-13) << order;
    }
  }
}

// k u as a term, or in the force with the opposite sign: the same integral of u.
TEST_P(OnEquations, ATermOfOrderZeroIsAForce) {
  if (!GetParam()->capabilities.implicit) return;
  constexpr double k = 2.5;
  const std::vector<Term> others{{0.4, 0.6}, {0.3, 1.4}};
  std::vector<Term> all = others;
  all.push_back({k, 0.0});
  const Chain without({1.0, 2.0}, others, {1.0, -0.5}), with({1.0, 2.0}, all, {1.0, -0.5});
  const Problem forced = chain_problem(
      {{.chain = without, .force = [=](double, In y) { return -k * y[0]; }, .derivatives = LinearForce{-k}}},
      3.0);
  const Problem termed = chain_problem(
      {{.chain = with, .force = [](double, In) { return 0.0; }, .derivatives = LinearForce{0.0}}}, 3.0);
  for (const auto& grid : grids_of(*GetParam(), 3.0, 300)) {
    if (GetParam()->capabilities.uniform_grid) continue;  // the Taylor part of a term is integrated exactly
    const Rows a = run(forced, grid).y, b = run(termed, grid).y;
    EXPECT_LT((a - b).row(0).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(OnEquations, HistoriesAgree) {
  const Problem problem = coupled();
  for (const auto& grid : grids_of(*GetParam(), problem.end, 700)) {
    const auto path = [&](HistoryKind kind) { return run(problem, grid, {.history = kind}); };
    const auto direct = path(HistoryKind::direct), exponentials = path(HistoryKind::exponentials);
    ASSERT_EQ(direct.status, SolveStatus::finished);
    ASSERT_EQ(exponentials.status, SolveStatus::finished);
    EXPECT_LE((direct.y - exponentials.y).cwiseAbs().maxCoeff(), 1e-13 * direct.y.cwiseAbs().maxCoeff())
        << "grading " << grid.grading;
  }
}

// One equation alone, and beside another with which it is not coupled. Start weights would depend on the
// orders of both.
TEST_P(OnEquations, EquationsThatDoNotDriveEachOtherEqualTheirOwnRuns) {
  if (GetParam()->starting_powers) return;
  const auto equation = [](Eigen::Index first, double alpha) {
    const Chain chain({1.0, 1.9}, {{0.5, alpha}}, {1.0, 0.5}, first);
    const auto u = chain.first_row();
    return MultiTermEquation{.chain = chain, .force = [=](double, In y) { return -std::sin(y[u]); }};
  };
  const auto first = equation(0, 0.4), second = equation(first.chain.size(), 1.2);
  const Rows together = run(chain_problem({first, second}, 2.0), 128).y;
  const Rows one = run(chain_problem({first}, 2.0), 128).y;
  const Rows other = run(chain_problem({equation(0, 1.2)}, 2.0), 128).y;
  EXPECT_LT((together.topRows(one.rows()) - one).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((together.bottomRows(other.rows()) - other).cwiseAbs().maxCoeff(), 1e-14);
}

// Compared with the spring pendulum as a chain with 64 times the steps, which shares nothing but the problem.
TEST_P(OnEquations, CoupledEquationsTendToWhatTheChainTendsTo) {
  Problem problem = scene_of("extensible_pendulum", {{"dphi0", 0.4}}).problem;
  problem.end = 4.0;
  const Rows chain = solve("product_trapezoidal", problem, 16384, {.output_times = {4.0}}).y;
  const auto distance = [&](int steps) {
    return (run(problem, steps, {.output_times = {4.0}}).y - chain).cwiseAbs().maxCoeff();
  };
  const double coarse = distance(128), fine = distance(256);
  EXPECT_LT(fine, 0.55 * coarse);
  EXPECT_LT(fine, GetParam()->capabilities.uniform_grid ? 2e-2 : 1e-4);
}

TEST_P(OnEquations, CallsAreCounted) {
  std::int64_t calls = 0;
  Problem problem = coupled();
  problem.equations[1].force = [&calls, force = problem.equations[1].force](double t, In y) {
    ++calls;
    return force(t, y);
  };
  const auto path = run(problem, 40);
  EXPECT_EQ(path.cost.rhs_calls, calls);
  EXPECT_EQ(path.cost.newton_iterations > 0, GetParam()->capabilities.implicit);
  if (!GetParam()->capabilities.implicit) {
    EXPECT_EQ(calls, 2 * 40);
  }
}

TEST_P(OnEquations, ALinearProblemTakesOneNewtonIterationAStep) {
  const auto path = run(scene_of("damped_oscillator").problem, 32);
  EXPECT_EQ(path.cost.newton_iterations, GetParam()->capabilities.implicit ? 32 : 0);
}

TEST_P(OnEquations, GivenDerivativesAndDifferencesGiveTheSameResult) {
  Problem problem = scene_of("extensible_pendulum").problem;
  problem.end = 2.0;
  const Rows first = run(problem, 64).y;
  problem.derivatives = NoDerivatives{};
  EXPECT_LT((run(problem, 64).y - first).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(OnEquations, OnlyTheStepsAskedForAreKeptWithTheSameBits) {
  const auto all = run(coupled(), 64), some = run(coupled(), 64, {.output_times = {0.0, 0.21875, 2.0}});
  EXPECT_EQ(some.times, (std::vector{0.0, 0.21875, 2.0}));
  EXPECT_EQ(some.y, Rows(all.y(Eigen::all, std::vector{0, 7, 64})));
}

TEST_P(OnEquations, BlowUpIsAnOutcomeWithItsStep) {
  const Chain chain({1.0, 0.5}, {{0.1, 0.2}}, {1.0});
  const auto path = run(
      chain_problem({{.chain = chain, .force = [](double, In y) { return y[0] * y[0] * y[0]; }}}, 50.0), 100);
  EXPECT_NE(path.status, SolveStatus::finished);
  EXPECT_EQ(path.last_time, path.times.back());
  EXPECT_DOUBLE_EQ(path.failure_time.value(), path.last_time + 0.5);
  EXPECT_TRUE(path.y.allFinite());
}

// D u = 60 D^0.5 u + 1: the step is divided by 1 - 60 kappa.
TEST_P(OnEquations, TermsThatGrowFasterThanTheStepsEndTheRun) {
  const auto path = [&](int steps) {
    const Chain chain({1.0, 1.0}, {{-60.0, 0.5}}, {0.0});
    return run(chain_problem({{.chain = chain, .force = [](double, In) { return 1.0; }}}, 1e-3), steps)
        .status;
  };
  EXPECT_EQ(path(1), SolveStatus::step_too_large);
  EXPECT_EQ(path(4), SolveStatus::finished);
}

TEST_P(OnEquations, RefusalsNameTheReason) {
  const Scheme& scheme = *GetParam();
  const Grid grid{1.0, 10};
  Problem problem = coupled();
  problem.components.push_back({0.5, {0.0}});
  EXPECT_EQ(unsupported_reason(scheme, problem, grid),
            "discretises multi-term equations only: 1 of 7 rows are of none");
  const Chain high({1.0, 2.5}, {}, {0.0, 0.0, 0.0});
  EXPECT_EQ(unsupported_reason(
                scheme, chain_problem({{.chain = high, .force = [](double, In) { return 0.0; }}}, 1.0), grid),
            "takes leading orders up to 2, not 2.5");
  EXPECT_EQ(unsupported_reason(scheme, scene_of("brusselator").problem, grid),
            "discretises multi-term equations, and the problem is not given in multi-term form");
  EXPECT_EQ(unsupported_reason(scheme, coupled(), Grid{1.0, 10, 2.0}).value_or("accepted"),
            scheme.capabilities.uniform_grid ? "needs a uniform grid, not one graded with 2" : "accepted");
}

// y' = -y: backward Euler, the trapezoidal rule, and the trapezoidal rule with the newest slope at a
// prediction (slopes extrapolated linearly), which in the first step is Heun's method.
TEST(OnEquationsOfOrderOne, TheSchemesAreClassicalMethods) {
  constexpr double h = 0.05;
  const Problem decay = test_problem(*find_scheme("multi_term_pc"), 1.0, -1.0);
  const Rows trapezoidal = solve("multi_term_trapezoidal", decay, 20).y,
             euler = solve("multi_term_grunwald_letnikov", decay, 20).y,
             predicted = solve("multi_term_pc", decay, 20).y;
  double known = 1.0 - h / 2, before = 1.0, last = 1.0;
  for (int n = 1; n <= 20; ++n) {
    const double prediction = known - h / 2 * (2.0 * last - before);
    before = std::exchange(last, known - h / 2 * prediction);
    known -= h * last;
    EXPECT_NEAR(predicted(0, n), last, 1e-14) << n;
    EXPECT_NEAR(trapezoidal(0, n), std::pow((1.0 - h / 2) / (1.0 + h / 2), n), 1e-14) << n;
    EXPECT_NEAR(euler(0, n), std::pow(1.0 + h, -n), 1e-14) << n;
  }
  EXPECT_NEAR(predicted(0, 1), 1.0 - h + h * h / 2, 1e-15);
}

}  // namespace
}  // namespace fde::bench
