// SPDX-License-Identifier: MIT
// Properties of every scheme, whatever its formulas. A new line in list.def is tested here without further
// code.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class Conformance : public SchemeTest {
 protected:
  // They have a common denominator, so that the commensurate expansion is tested too.
  static std::vector<double> orders() {
    std::vector<double> all{0.2, 0.5, 0.8, 1.0, 1.3, 1.7, 2.0};
    const auto& refuses = GetParam()->unsupported_problem_reason;
    if (refuses)
      std::erase_if(all, [&](double order) { return refuses({.components = {component(order, 0.0)}}); });
    return all;
  }

  static Component component(double order, double value, double slope = 0.0) {
    return order > 1.0 ? Component{order, {value, slope}} : Component{order, {value}};
  }
};

class ImplicitConformance : public Conformance {};

TEST_P(Conformance, ConstantsAreExact) {
  for (const double order : orders()) {
    const auto path =
        run({.components = {component(order, 3.25)}, .rhs = [](double, In, Out f) { f.setZero(); }}, 50);
    EXPECT_EQ((path.y.array() - 3.25).abs().maxCoeff(), 0.0) << order;
  }
}

// Except where fractional links integrate the velocity to y: they only approximate its integral.
TEST_P(Conformance, WithoutRightHandSideOnlyTheTaylorPartIsLeft) {
  for (const double order : orders()) {
    if (order <= 1.0) continue;
    const auto path = run(
        {.components = {component(order, 1.0, -0.75)}, .rhs = [](double, In, Out f) { f.setZero(); }}, 64);
    if (path.cost.components > 2) continue;
    const auto taylor = 1.0 - 0.75 * Eigen::ArrayXd::LinSpaced(65, 0.0, 1.0);
    EXPECT_LT((path.y.row(0).transpose().array() - taylor).abs().maxCoeff(), 1e-14) << order;
  }
}

// J^g 1 = t^g / Gamma(g+1): exact for rules that interpolate f, of rate 1 or better for the others.
TEST_P(Conformance, AConstantRightHandSideGivesItsFractionalIntegral) {
  for (const double order : orders()) {
    const Problem problem{.components = {component(order, 0.0)},
                          .rhs = [](double, In, Out f) { f.setOnes(); }};
    EXPECT_NEAR(run(problem, 2000).y(0, 2000), 1.0 / std::tgamma(order + 1.0), 2e-3) << order;
  }
}

Problem mixed_problem() {
  return {.components = {{0.5, {1.0}}, {1.0, {-0.5}}, {1.5, {0.25, 0.1}}},
          .rhs = [](double t, In y,
                    Out f) { f << -y[0] + std::sin(y[1]), -y[1] * y[2] + t, -2.0 * y[2] + y[0] * y[0]; },
          .end = 2.0};
}

// The same with y_2 = sin(y_1) + y_3 y_0 as an algebraic row between the others, on which the last one
// depends.
Problem mixed_problem_with_algebraic_row() {
  return {.components = {{0.5, {1.0}}, {1.0, {-0.5}}, {0.0, {std::sin(-0.5) + 0.25}}, {1.5, {0.25, 0.1}}},
          .rhs =
              [](double t, In y, Out f) {
                f << -y[0] + std::sin(y[1]), -y[1] * y[3] + t, y[2] - std::sin(y[1]) - y[3] * y[0],
                    -2.0 * y[3] + y[2] * y[2];
              },
          .end = 2.0};
}

std::vector<Problem> mixed_problems(const Scheme& scheme) {
  if (!scheme.capabilities.algebraic_rows) return {mixed_problem()};
  return {mixed_problem(), mixed_problem_with_algebraic_row()};
}

// The histories differ by rounding and the tolerance of the exponentials only, on every grid that the scheme
// takes.
TEST_P(Conformance, HistoriesAgree) {
  for (const auto& problem : mixed_problems(*GetParam())) {
    for (const auto& grid : grids_of(*GetParam(), problem.end, 700)) {
      const auto path = [&](HistoryKind kind) { return GetParam()->solve(problem, grid, {.history = kind}); };
      const auto direct = path(HistoryKind::direct), exponentials = path(HistoryKind::exponentials);
      ASSERT_EQ(direct.status, SolveStatus::finished);
      ASSERT_EQ(exponentials.status, SolveStatus::finished);
      EXPECT_LE((direct.y - exponentials.y).cwiseAbs().maxCoeff(), 1e-13 * direct.y.cwiseAbs().maxCoeff())
          << "grading " << grid.grading;
    }
  }
}

// The problem with its components in this order.
Problem permuted(const Problem& problem, const std::vector<Eigen::Index>& order) {
  Problem result{.rhs =
                     [=](double t, In y, Out f) {
                       Vec back(y.size()), g(y.size());
                       back(order) = y;
                       problem.rhs(t, back, g);
                       f = g(order);
                     },
                 .end = problem.end};
  for (const auto i : order) result.components.push_back(problem.components[static_cast<std::size_t>(i)]);
  return result;
}

TEST_P(Conformance, PermutingComponentsPermutesTheAnswer) {
  for (const auto& straight : mixed_problems(*GetParam())) {
    std::vector<Eigen::Index> order{2, 0, 1};
    if (straight.size() == 4) order.insert(order.begin(), 3);
    const Rows a = run(straight, 100).y, b = run(permuted(straight, order), 100).y;
    EXPECT_LT((Rows(a(order, Eigen::all)) - b).cwiseAbs().maxCoeff(), rounding_allowance(*GetParam(), 1e-13));
  }
}

// Start weights depend on the orders of all rows, so these are the same in every run.
TEST_P(Conformance, UncoupledSystemsEqualTheirScalarRuns) {
  const double other = GetParam()->starting_powers ? 0.5 : 1.5;
  const auto scalar = [](double order, double rate) {
    return Problem{.components = {component(order, 1.0)}, .rhs = [=](double, In y, Out f) { f = rate * y; }};
  };
  const Problem both{.components = {component(0.5, 1.0), component(other, 1.0)},
                     .rhs = [](double, In y, Out f) { f << -y[0], -3.0 * y[1]; }};
  const auto together = run(both, 128);
  const auto first = run(scalar(0.5, -1.0), 128), second = run(scalar(other, -3.0), 128);
  EXPECT_LT((together.y.row(0) - first.y.row(0)).cwiseAbs().maxCoeff(),
            rounding_allowance(*GetParam(), 1e-14));
  EXPECT_LT((together.y.row(1) - second.y.row(0)).cwiseAbs().maxCoeff(),
            rounding_allowance(*GetParam(), 1e-14));
}

TEST_P(Conformance, ALinearPartAJacobianAndDifferencesGiveTheSameAnswer) {
  const Matrix a = (Matrix(2, 2) << -1.0, 2.0, -2.0, -0.5).finished();
  Problem problem{.components = {component(0.5, 1.0), component(1.5, 0.0)},
                  .rhs = [=](double t, In y, Out f) { f = a * y + Vec::Constant(2, std::cos(t)); }};
  const Rows differenced = run(problem, 64).y;
  problem.derivatives = DenseJacobian{[=](double, In, OutMatrix jacobian) { jacobian = a; }};
  const Rows newton = run(problem, 64).y;
  problem.derivatives = DenseLinearPart{a};
  const Rows linear = run(problem, 64).y;
  EXPECT_LT((differenced - newton).cwiseAbs().maxCoeff(), rounding_allowance(*GetParam(), 1e-13));
  EXPECT_LT((linear - newton).cwiseAbs().maxCoeff(), rounding_allowance(*GetParam(), 1e-13));
}

TEST_P(Conformance, CallsAreCounted) {
  std::int64_t calls = 0;
  Problem problem = mixed_problems(*GetParam()).back();
  problem.rhs = [&calls, rhs = problem.rhs](double t, In y, Out f) {
    ++calls;
    rhs(t, y, f);
  };
  const auto path = GetParam()->solve(problem, Grid{problem.end, 40}, {});
  EXPECT_EQ(path.cost.rhs_calls, calls);
  EXPECT_EQ(path.cost.newton_iterations > 0, GetParam()->capabilities.implicit);
  if (!GetParam()->capabilities.implicit) {
    EXPECT_TRUE(calls == 40 || calls == 80) << calls << ", not one a step or, with a corrector, two";
  }
}

TEST_P(Conformance, ALinearProblemTakesOneNewtonIterationAStep) {
  const auto scene = scene_of("damped_oscillator");
  const auto path = run(scene.problem, 32);
  EXPECT_EQ(path.cost.newton_iterations, GetParam()->capabilities.implicit ? 32 : 0);
}

TEST_P(Conformance, OnlyTheStepsAskedForAreKept) {
  const auto all = run(mixed_problem(), 64),
             some = run(mixed_problem(), 64, {.output_times = {0.0, 0.21875, 2.0}});
  EXPECT_EQ(some.times, (std::vector{0.0, 0.21875, 2.0}));
  EXPECT_EQ(some.y, Rows(all.y(Eigen::all, std::vector{0, 7, 64})));
}

TEST_P(Conformance, TheSameInputGivesTheSameBits) {
  EXPECT_EQ(run(mixed_problem(), 64).y, run(mixed_problem(), 64).y);
}

TEST_P(Conformance, BlowUpIsAnOutcomeWithItsStep) {
  const auto path = run({.components = {{0.5, {1.0}}},
                         .rhs = [](double, In y, Out f) { f = y.array().cube().matrix(); },
                         .end = 50.0},
                        100);
  EXPECT_NE(path.status, SolveStatus::finished);
  EXPECT_LT(path.steps, 100);
  EXPECT_EQ(path.y.cols(), path.steps + 1);
  EXPECT_EQ(path.last_time, path.times.back());
  EXPECT_DOUBLE_EQ(path.failure_time.value(), path.last_time + 0.5);
  EXPECT_TRUE(path.y.allFinite());
}

TEST_P(ImplicitConformance, AnImpossibleStepIsAnOutcome) {
  // y = known + kappa (1e6 + y^2) has no real solution.
  const auto path =
      run({.components = {{0.5, {0.0}}}, .rhs = [](double, In y, Out f) { f[0] = 1e6 + y[0] * y[0]; }}, 4);
  EXPECT_EQ(path.status, SolveStatus::not_converged);
  EXPECT_EQ(path.last_time, 0.0);
  EXPECT_EQ(path.failure_time, 0.25);
  EXPECT_LT(path.cost.newton_iterations, 400);
}

TEST_P(Conformance, RefusalsNameTheReason) {
  const auto refuses = [](double order, std::vector<double> initial, const Grid& grid) {
    const Problem problem{.components = {{order, std::move(initial)}},
                          .rhs = [](double, In, Out f) { f.setZero(); }};
    return unsupported_reason(*GetParam(), problem, grid).value_or("accepted");
  };
  const Grid grid{1.0, 10};
  const auto& capabilities = GetParam()->capabilities;
  const auto in_range = fmt::format("takes orders in {}0, {}], component 0 has ",
                                    capabilities.algebraic_rows ? '[' : '(', capabilities.max_order);
  EXPECT_EQ(refuses(2.5, {1, 0, 0}, grid), in_range + "2.5");
  EXPECT_EQ(refuses(-0.5, {1}, grid), in_range + "-0.5");
  EXPECT_EQ(refuses(0.0, {1}, grid),
            capabilities.algebraic_rows ? "accepted"
            : capabilities.implicit     ? "takes no algebraic rows: component 0 is an algebraic row (order 0)"
                                        : "steps explicitly: component 0 is an algebraic row (order 0)");
  EXPECT_EQ(refuses(std::nan(""), {1}, grid), in_range + "nan");
  EXPECT_EQ(refuses(1.5, {1}, grid), "needs 2 initial values for order 1.5, component 0 has 1");
  EXPECT_EQ(refuses(0.5, {1}, {1.0, 10, 2.0}),
            capabilities.uniform_grid ? "needs a uniform grid, not one graded with 2" : "accepted");
}

INSTANTIATE_TEST_SUITE_P(, Conformance, testing::ValuesIn(row_schemes()), id_of_param);
INSTANTIATE_TEST_SUITE_P(, ImplicitConformance, testing::ValuesIn(implicit_schemes()), id_of_param);

// Whole trajectories. The brusselator amplifies rounding, so its bound is ten times the others'.
TEST_P(Conformance, HistoriesAgreeOnScenes) {
  for (const auto* id : {"pendulum", "extensible_pendulum", "brusselator", "fractional_oscillator"}) {
    const auto scene = scene_of(id);
    if (unsupported_reason(*GetParam(), scene.problem, Grid{scene.problem.end, 1})) continue;
    const Rows direct = run(scene.problem, 4096, {.history = HistoryKind::direct}).y;
    const Rows exponentials = run(scene.problem, 4096, {.history = HistoryKind::exponentials}).y;
    const auto relative = (exponentials - direct).rowwise().lpNorm<Eigen::Infinity>().array() /
                          direct.rowwise().lpNorm<Eigen::Infinity>().array();
    EXPECT_LT(relative.maxCoeff(), id == std::string_view("brusselator") ? 1e-12 : 1e-13) << id;
  }
}

// Relations between schemes.

// y' = -y: at order 1 each rule is a classical method, whose step multiplies y by a known factor. The
// predictor of the Adams schemes sums f of corrected values, so they are Heun's method in the first step
// only.
TEST(Identities, OfOrderOneTheSchemesAreClassicalMethods) {
  struct Classical {
    const char* scheme;
    double factor;
    int steps;
  };
  constexpr double h = 0.05, heun = 1.0 - h + h * h / 2, backward_euler = 1.0 / (1.0 + h);
  constexpr double trapezoidal = (1.0 - h / 2) / (1.0 + h / 2);
  const Problem decay{.components = {{1.0, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }};
  for (const auto& [scheme, factor, steps] : {Classical{"adams_pc", heun, 1},
                                              {"decoupled_multi_order", heun, 1},
                                              {"commensurate_adams_pc", heun, 1},
                                              {"l1", backward_euler, 20},
                                              {"grunwald_letnikov", backward_euler, 20},
                                              {"bdf1", backward_euler, 20},
                                              {"newton_gregory_2", trapezoidal, 20},
                                              {"fractional_trapezoidal", trapezoidal, 20},
                                              {"product_trapezoidal", trapezoidal, 20}}) {
    const auto path = solve(scheme, decay, 20);
    for (int n = 1; n <= steps; ++n)
      EXPECT_NEAR(path.y(0, n), std::pow(factor, n), 1e-14) << scheme << ", n = " << n;
  }
}

TEST(Identities, TheDecoupledChainIsAdamsWhereNoOrderIsAboveOne) {
  const auto scene = scene_of("pendulum");
  EXPECT_EQ(solve("decoupled_multi_order", scene.problem, 200).y, solve("adams_pc", scene.problem, 200).y);
}

TEST(Identities, ManyCorrectionsSolveTheProductTrapezoidalRule) {
  const auto scene = scene_of("pendulum");
  const Rows corrected = solve("adams_pc", scene.problem, 400, {.corrections = 60}).y;
  EXPECT_LT((corrected - solve("product_trapezoidal", scene.problem, 400).y).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Identities, OfOrderOneL1AndGrunwaldLetnikovAreTheSameMethod) {
  const auto scene = scene_of("brusselator", {{"gamma", 1.0}});
  const Rows a = solve("l1", scene.problem, 2000).y, b = solve("grunwald_letnikov", scene.problem, 2000).y;
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Refusal, OrdersWithoutACommonDenominator) {
  const auto scene = scene_of("relaxation", {{"gamma", 1.0 / std::numbers::pi}});
  EXPECT_EQ(unsupported_reason(*find_scheme("commensurate_adams_pc"), scene.problem, Grid{1.0, 8}),
            "needs orders that are multiples of one 1/M with M at most 64");
}

TEST(Registry, UnknownSchemesAreNotFound) { EXPECT_EQ(find_scheme("adams"), nullptr); }

}  // namespace
}  // namespace fde::bench
