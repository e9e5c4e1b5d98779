// SPDX-License-Identifier: MIT
// Spectral collocation: the accuracy for a given tolerance, and how runs end that cannot finish.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

const Scheme& scheme() { return *find_scheme("spectral_collocation"); }

Trajectory run(const Problem& problem, double accuracy, const Options& options = {}) {
  return scheme().solve(problem, Tolerance{accuracy, accuracy}, options);
}

AccuracyRun spectral_run(const std::string& scene, const ParameterValues& values = {}) {
  return {"spectral_collocation", scene, values};
}

// With the constraint as an algebraic row; alpha is the order of the scene's memory term, if it has one.
AccuracyRun multiplier(const std::string& scene, std::optional<double> alpha = {}) {
  AccuracyRun asked = spectral_run(scene, {{"formulation", "multiplier"}});
  if (alpha) asked.values["alpha"] = *alpha;
  return asked;
}

class Spectral : public testing::TestWithParam<AccuracyRun> {};

// At the run's own times, the first of which are close to a singular start.
TEST_P(Spectral, DeliversTheAccuracy) {
  const Scene scene = scene_of(GetParam().scene, GetParam().values);
  const auto reference = reference_of(scene);
  for (const double accuracy : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto path = run(scene.problem, accuracy);
    ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
    EXPECT_EQ(path.last_time, scene.problem.end);
    EXPECT_EQ(path.steps, std::ssize(path.times) - 1);
    EXPECT_LT(largest_error(scene, reference, path, 4.0), accuracy) << accuracy;
  }
}

INSTANTIATE_TEST_SUITE_P(
    SceneRegistry, Spectral,
    testing::Values(
        spectral_run("relaxation"), spectral_run("relaxation", {{"gamma", 0.1}}),
        spectral_run("relaxation", {{"gamma", 1.7}}), spectral_run("relaxation", {{"gamma", 1.0}}),
        spectral_run("relaxation", {{"lambda", 20.0}}), spectral_run("relaxation_pair"),
        spectral_run("power", {{"gamma", 0.2}, {"p", 0.3}}), spectral_run("diethelm"),
        spectral_run("linear_system"), spectral_run("volterra_equation"),
        spectral_run("volterra_equation", {{"p", 0.2}}), spectral_run("settling_sphere"),
        spectral_run("fractional_control"), spectral_run("distributed_relaxation"),
        spectral_run("fractional_oscillator"), spectral_run("damped_oscillator"), spectral_run("pendulum"),
        spectral_run("extensible_pendulum"), spectral_run("multi_term"), spectral_run("brusselator"),
        spectral_run("van_der_pol", {{"mu", 1e4}}), spectral_run("robertson"),
        spectral_run("stiff_relaxation", {{"lambda", -1e8}}), spectral_run("fractional_constraint_2d"),
        spectral_run("knife_edge"), spectral_run("canonical_ensemble"), spectral_run("fractional_knife_edge"),
        multiplier("nonholonomic_particle"), multiplier("blade_on_sphere"), multiplier("isokinetic"),
        multiplier("fractional_constraint_2d", 0.8), multiplier("fractional_constraint_nonlinear", 0.3),
        multiplier("fractional_knife_edge", 0.8), spectral_run("fractional_diffusion"),
        spectral_run("fractional_diffusion", {{"gamma", 1.5}, {"start", "step"}}),
        spectral_run("fractional_diffusion_2d", {{"medium", "halves"}}),
        spectral_run("fractional_allen_cahn", {{"epsilon", 0.02}})),
    name_of_run);

// Elimination in all points and unknowns at once, and the Schur form of the integrals with the Jacobians as a
// preconditioner: sparse, or dense with these many rows.
TEST(SpectralMatrix, OfOneOrderGivesTheSolutionOfDenseElimination) {
  for (const double amplitude : {0.0, 5.0}) {
    const auto problem_of = [&](Eigen::Index rows) {
      Problem problem{.components = {static_cast<std::size_t>(rows), Component{0.7, {0.3}}}, .end = 2.0};
      problem.rhs = [=](double t, In y, Out f) {
        for (Eigen::Index i = 0; i < y.size(); ++i) {
          const Eigen::Index next = i % 4 == 3 ? i - 3 : i + 1;
          f[i] = std::cos(t) - 40.0 * y[i] + 30.0 * y[next] + amplitude * std::sin(3.0 * y[i]);
        }
      };
      return problem;
    };
    const Tolerance accuracy{1e-10, 1e-10};
    const Problem single = problem_of(4), copies = problem_of(24);
    ASSERT_EQ(scheme().solve(single, accuracy, {}).cost.linear_solver, "");
    const auto of_four = scheme().solve(single, accuracy, {.output_times = {0.01, 0.5, 2.0}});
    const auto of_all = scheme().solve(copies, accuracy, {.output_times = {0.01, 0.5, 2.0}});
    ASSERT_EQ(of_all.status, SolveStatus::finished);
    ASSERT_NE(of_all.cost.linear_solver, "");
    for (Eigen::Index i = 0; i < copies.size(); ++i)
      EXPECT_LT((of_all.y.row(i) - of_four.y.row(i % 4)).cwiseAbs().maxCoeff(), 1e-10) << i;
  }
}

// The zeros of events and the values between panels too.
TEST(SpectralMatrix, OfASparseJacobianGivesTheSolutionOfADenseOne) {
  Problem problem = scene_of("fractional_diffusion", {{"components", 24.0}, {"medium", "wave"}}).problem;
  const Options options{.output_times = {0.003, 0.4, 1.0},
                        .events = {{.value = [](double, In y) { return y[0] - 0.05; }}}};
  const Tolerance accuracy{1e-10, 1e-10};
  const auto sparse = scheme().solve(problem, accuracy, options);
  problem.derivatives = DenseLinearPart{std::get<SparseLinearPart>(problem.derivatives).matrix};
  const auto dense = scheme().solve(problem, accuracy, options);
  ASSERT_EQ(sparse.status, SolveStatus::finished);
  EXPECT_LT((sparse.y - dense.y).cwiseAbs().maxCoeff(), 1e-12);
  ASSERT_EQ(sparse.events.size(), 1U);
  ASSERT_EQ(dense.events.size(), 1U);
  EXPECT_NEAR(sparse.events[0].t, dense.events[0].t, 1e-10);
}

// Twice the unknowns take twice the memory, and the same number of iterations to 5 %.
TEST(SpectralMatrix, OfASparseJacobianCostsByItsEntries) {
  const auto cost = [](double n) {
    const auto path =
        run(scene_of("fractional_diffusion", {{"components", n}}).problem, 1e-8, {.output_times = {1.0}});
    EXPECT_EQ(path.status, SolveStatus::finished) << n;
    EXPECT_EQ(path.cost.linear_solver, "tridiagonal") << n;
    return path.cost;
  };
  const Cost small = cost(500), large = cost(1000);
  EXPECT_NEAR(static_cast<double>(*large.newton_iterations), static_cast<double>(*small.newton_iterations),
              0.05 * static_cast<double>(*small.newton_iterations));
  EXPECT_NEAR(static_cast<double>(*large.history_bytes) / static_cast<double>(*small.history_bytes), 2.0,
              0.1);
}

// The load of Bagley and Torvik ends at t = 1, where a new segment begins: no accuracy is lost there.
TEST(SpectralJump, IsStartedFrom) {
  const Scene scene = scene_of("bagley_torvik");
  const auto reference = reference_of(scene);
  std::vector<double> at{0.3, 1.0, 1.0 + 0x1p-20, 1.1, 5.0, scene.problem.end};
  const auto path = run(scene.problem, 1e-10, {.output_times = at});
  ASSERT_EQ(path.times, at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec error = columns_at(scene.outputs, at[i], path.y.col(static_cast<Eigen::Index>(i))) -
                      reference.at(at[i]).value;
    EXPECT_LT(error.lpNorm<Eigen::Infinity>(), 1e-10) << at[i];
  }
}

// The result does not depend on the value of f at the jump t = 1, where panels are far shorter than rounding
// of 1.
TEST(SpectralJump, DoesNotAskOnWhichSideOfAJumpItsTimeIs) {
  const auto values = [](bool included) {
    const Problem problem{
        .components = {{0.5, {0.0}}},
        .rhs = [=](double t, In, Out f) { f[0] = (included ? t <= 1.0 : t < 1.0) ? 1.0 : -1.0; },
        .end = 3.0,
        .jump_times = {1.0}};
    return run(problem, 1e-12, {.output_times = {1.0, 1.0 + 1e-13, 1.0 + 1e-6, 2.0}}).y;
  };
  EXPECT_EQ(values(true), values(false));
}

TEST(SpectralSwitch, IsLocatedToRounding) {
  const std::vector<double> at{0.5, 0.785, 0.786, 1.0, 2.0};
  for (const double accuracy : {1e-3, 1e-6, 1e-12}) {
    const auto path = run(switching_problem(), accuracy, {.output_times = at});
    ASSERT_EQ(path.times, at);
    expect_row(path, 0, solution_of_switching_problem, std::max(accuracy, 1e-11));
  }
}

// D^0.8 y = sign(sin 50 t) - y, with jumps at k pi/50 that are not listed in Problem::jump_times: each
// changes y by 2 (1 - E(-(t - t_k)^0.8)).
TEST(SpectralJump, IsDetectedWhereItIsNotListed) {
  const Problem problem{
      .components = {{0.8, {0.0}}},
      .rhs = [](double t, In y, Out f) { f[0] = std::copysign(1.0, std::sin(50.0 * t)) - y[0]; },
      .derivatives = DenseLinearPart{-Matrix::Identity(1, 1)},
      .end = 4.0};
  const double accuracy = 1e-6;
  const auto path = run(problem, accuracy, {.output_times = {1.0, 2.0, 3.0, 4.0}});
  ASSERT_EQ(path.times.size(), 4U);
  const auto response = [](double t) { return 1.0 - reference::mittag_leffler(0.8, 1.0, -std::pow(t, 0.8)); };
  const auto exact = [&](double t) {
    double sum = response(t);
    for (int k = 1; k * std::numbers::pi / 50.0 < t; ++k)
      sum += (k % 2 == 0 ? 2.0 : -2.0) * response(t - k * std::numbers::pi / 50.0);
    return sum;
  };
  expect_row(path, 0, exact, 10.0 * accuracy);
}

// D^g y = 1, and -2 where y > 1/2: y slides along 1/2, and no solution exists after that time. The run
// reports the time, also for a right-hand side that is declared linear.
TEST(SpectralSwitch, EndsWhereTheSolutionSlides) {
  for (const double order : {0.2, 0.9, 1.0}) {
    for (const double accuracy : {1e-3, 1e-7}) {
      const Problem problem{.components = {{order, {0.0}}},
                            .rhs = [](double, In y, Out f) { f[0] = y[0] > 0.5 ? -2.0 : 1.0; },
                            .derivatives = DenseLinearPart{Matrix::Zero(1, 1)},
                            .end = 2.0,
                            .switching_functions = {[](double, In y) { return y[0] - 0.5; }}};
      const auto path = run(problem, accuracy);
      EXPECT_EQ(path.status, SolveStatus::sliding) << order << ' ' << accuracy;
      EXPECT_NEAR(path.failure_time.value_or(0.0), std::pow(0.5 * std::tgamma(1.0 + order), 1.0 / order),
                  1e-3);
    }
  }
}

// x' = 1 and D^g v = floor(x) - v, whose switches the solution crosses at t = 0.7, 1.7, ... Behind these,
// panels are shorter than the rounding error of t.
Problem staircase(double order, double end) {
  return {.components = {{1.0, {0.3}}, {order, {0.0}}},
          .rhs = [](double, In y, Out f) { f << 1.0, std::floor(y[0]) - y[1]; },
          .end = end,
          .switching_functions = {[](double, In y) { return std::sin(std::numbers::pi * y[0]); }}};
}

TEST(SpectralSwitch, TimesIncreaseBehindIt) {
  const auto path = run(staircase(0.05, 1.5), 1e-4);
  ASSERT_EQ(path.status, SolveStatus::finished);
  EXPECT_EQ(std::ranges::adjacent_find(path.times, std::greater_equal<>()), path.times.end());
}

// v = the sum of 1 - E_g(-(t - t_i)^g) over the switches t_i before t.
TEST(SpectralSwitch, IsCrossedAtSmallOrders) {
  for (const double order : {0.02, 0.05, 0.1, 0.2}) {
    double v = 0.0;
    for (const double crossed : {0.7, 1.7, 2.7})
      v += 1.0 - reference::mittag_leffler(order, 1.0, -std::pow(3.0 - crossed, order));
    for (const double accuracy : {1e-4, 1e-6, 1e-9}) {
      const auto path = run(staircase(order, 3.0), accuracy);
      ASSERT_EQ(path.status, SolveStatus::finished) << order << ' ' << accuracy;
      EXPECT_NEAR(path.dense_output(3.0)[1], v, accuracy) << order;
    }
  }
}

// D^g y = lambda and y = t: lambda = t^(1-g) / Gamma(2-g), Abel's equation.
TEST(SpectralAlgebraic, RowsSolveAbelsEquation) {
  for (const double order : {0.2, 0.5, 0.9, 1.0}) {
    const Problem problem{.components = {{order, {0.0}}, {0.0, {0.0}}},
                          .rhs = [](double t, In y, Out f) { f << y[1], y[0] - t; }};
    const auto path = run(problem, 1e-9);
    ASSERT_EQ(path.status, SolveStatus::finished) << order;
    for (const double t : {0.01, 0.3, 1.0}) {
      EXPECT_NEAR(path.dense_output(t)[1], std::pow(t, 1.0 - order) / std::tgamma(2.0 - order), 1e-8)
          << order << ' ' << t;
    }
  }
}

// D^0.5 y = -z and y = z^3, compared with D^0.5 y = -y^(1/3), whose slope at y = 0 is infinite.
TEST(SpectralAlgebraic, RowsDetermineTheirOwnUnknown) {
  const Problem with_row{.components = {{0.5, {1.0}}, {0.0, {1.0}}},
                         .rhs = [](double, In y, Out f) { f << -y[1], y[0] - std::pow(y[1], 3.0); }};
  const Problem without{.components = {{0.5, {1.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = -std::cbrt(y[0]); }};
  const double y = run(without, 1e-11, {.output_times = {0.3}}).y(0, 0);
  const auto found = run(with_row, 1e-11, {.output_times = {0.3}});
  EXPECT_NEAR(found.y(0, 0), y, 1e-11);
  EXPECT_NEAR(found.y(1, 0), std::cbrt(y), 1e-10);
}

// y' + lambda = 0 with y = t up to 1 and y = 1 after it: lambda jumps from -1 to 0.
TEST(SpectralAlgebraic, RowsMayJump) {
  const Problem problem{.components = {{1.0, {0.0}}, {0.0, {0.0}}},
                        .rhs = [](double t, In y, Out f) { f << -y[1], y[0] - std::min(t, 1.0); },
                        .end = 2.0,
                        .jump_times = {1.0}};
  const auto path = run(problem, 1e-10, {.output_times = {0.5, 1.5, 2.0}});
  ASSERT_EQ(path.status, SolveStatus::finished);
  EXPECT_LT((path.y.row(1) - Eigen::RowVector3d(-1.0, 0.0, 0.0)).cwiseAbs().maxCoeff(), 1e-9);
}

// Volterra's equation v = 1 - I^g v, as D^g z = v, 0 = 1 - z - v, and the cubic one v + v^3 = 2 - I^g v, for
// v to leading order in t^g: within the first panel too v follows a power of t.
TEST(SpectralAlgebraic, RowsFollowAPowerOfTimeWithinTheFirstPanel) {
  const double order = 0.4;
  for (const double cubic : {0.0, 1.0}) {
    const Problem problem{.components = {{order, {0.0}}, {0.0, {1.0}}}, .rhs = [=](double, In y, Out f) {
                            f << y[1], 1.0 + cubic - y[0] - y[1] - cubic * std::pow(y[1], 3.0);
                          }};
    const std::vector<double> early{1e-16, 1e-13, 1e-11, 1e-9};
    for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
      const auto path = run(problem, accuracy, {.output_times = early});
      ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
      for (std::size_t i = 0; i < early.size(); ++i) {
        const double first = std::pow(early[i], order) / (std::tgamma(order + 1.0) * (1.0 + 3.0 * cubic));
        EXPECT_NEAR(path.y(1, static_cast<Eigen::Index>(i)), 1.0 - first,
                    2.0 * accuracy + 2.0 * first * first)
            << "cubic " << cubic << ", accuracy " << accuracy << ", t = " << early[i];
      }
    }
  }
}

// lambda ~ t^-0.8 at the start.
TEST(SpectralAlgebraic, RowsResolveASingularReaction) {
  const Scene scene = scene_of("fractional_constraint_2d", {{"formulation", "multiplier"}, {"alpha", 0.8}});
  const auto reference = reference_of(scene);
  const auto path = run(scene.problem, 1e-10);
  for (const double t : {1e-3, 0.1, 1.0, 7.3}) {
    const double exact = exact_reactions(scene, t, reference.at(t).value)[0];
    EXPECT_NEAR(path.dense_output(t).tail<1>()[0], exact, 1e-8 * std::abs(exact)) << t;
  }
}

// D^0.5 y = -1e6 y falls to 5.6e-7, a millionth of the terms that are summed to y.
TEST(SpectralStiff, KeepsTheDigitsOfWhatIsLeft) {
  const Scene scene = scene_of("stiff_relaxation");
  const auto path = scheme().solve(scene.problem, Tolerance{1e-10, 1e-300}, {.output_times = {1.0}});
  const double exact = reference::mittag_leffler(0.5, 1.0, -1e6);
  EXPECT_NEAR(path.y(0, 0) / exact, 1.0, 1e-8);
}

// Where f makes y decay quickly, rounding limits the accuracy of f, and this suffices: as few panels as for
// an absolute tolerance.
TEST(SpectralStiff, TakesFewPanelsToARelativeAccuracy) {
  for (const auto& [lambda, end] : {std::pair{-1e8, 1.0}, std::pair{-1.0, 1e100}}) {
    const Scene scene = scene_of("relaxation", {{"lambda", lambda}});
    Problem problem = scene.problem;
    problem.end = end;
    const auto path = scheme().solve(problem, Tolerance{1e-6, 1e-300}, {.budget = 2.0});
    EXPECT_EQ(path.status, SolveStatus::finished) << lambda;
    EXPECT_LT(path.steps, 500) << lambda;
  }
}

TEST(SpectralDense, IsTheSolutionAtAnyTime) {
  const Scene scene = scene_of("relaxation");
  const auto path = run(scene.problem, 1e-11);
  ASSERT_TRUE(path.dense_output);
  for (const double t : {1e-30, 1e-12, 1e-4, 0.013, 0.5, 0.77, 1.0}) {
    EXPECT_NEAR(path.dense_output(t)[0], reference::mittag_leffler(0.5, 1.0, -std::sqrt(t)), 1e-11) << t;
  }
}

// t^p is far smaller at first than at the end of panels that suffice for the end alone; and an error of a
// load t^(2-nu), order close to 2, acts as an error of the velocity that does not decay.
TEST(SpectralAccuracy, HoldsWhereASolutionIsSmallAndWhereAnErrorIsRemembered) {
  const auto check = [](const std::string& name, const ParameterValues& values, double end, double accuracy) {
    Scene scene = scene_of(name, values);
    scene.problem.end = end;
    const auto reference = reference_of(scene);
    for (const double t : {0.1, 0.3, 0.5, 1.0, 2.0, 3.0}) {
      const auto path = run(scene.problem, accuracy, {.output_times = {t}});
      ASSERT_EQ(path.times.size(), 1U);
      const double exact = reference.at(t).value[0];
      EXPECT_NEAR(path.y(0, 0), exact, 10.0 * accuracy * (1.0 + std::abs(exact))) << name << ' ' << t;
    }
  };
  check("power", {{"gamma", 0.5}, {"p", 12.0}}, 4.0, 1e-10);
  check("fractional_oscillator", {{"nu", 1.937}, {"c2", 1.0}}, 3.0, 1e-11);
  check("fractional_oscillator", {{"nu", 1.937}, {"c2", 1.0}}, 3.0, 1e-13);
}

// Without gravity the blade rotates in place: rows that are 0 do not affect the error test.
TEST(SpectralOrders, NonlinearRowsRestAtZero) {
  const auto path = run(scene_of("knife_edge", {{"g", 0.0}}).problem, 1e-6);
  ASSERT_EQ(path.status, SolveStatus::finished);
  const Vec end = path.y.rightCols<1>();
  EXPECT_EQ(end.head<2>(), Vec::Zero(2));
  EXPECT_NEAR(end[2], 10.0, 1e-6);
}

// D^0.5 y = y^3 has another root from the first long panel on.
TEST(SpectralEnd, IsNotOnAnotherRoot) {
  const Problem problem{
      .components = {{0.5, {1.0}}}, .rhs = [](double, In y, Out f) { f = y.array().cube(); }, .end = 2.0};
  for (const double accuracy : {1e-2, 1e-4, 1e-8}) {
    const auto path = run(problem, accuracy);
    EXPECT_NE(path.status, SolveStatus::finished) << accuracy;
    EXPECT_GE(path.y.minCoeff(), 1.0) << accuracy;
  }
}

// A mode e^(2500 t): a result that does not contain it is smooth and wrong.
TEST(SpectralEnd, IsNotPastAModeThatGrows) {
  for (const double accuracy : {1e-2, 1e-3, 1e-6}) {
    const auto path = run(scene_of("fractional_constraint_2d", {{"alpha", 1.5}}).problem, accuracy);
    EXPECT_NE(path.status, SolveStatus::finished) << accuracy;
  }
}

TEST(SpectralRefusal, SaysWhatItDoesNotTake) {
  Problem problem = scene_of("fractional_diffusion").problem;
  problem.components.front().order = 0.6;
  EXPECT_EQ(unsupported_reason(scheme(), problem, Tolerance{1e-6, 1e-6}).value_or(""),
            "takes sparse Jacobians only where all rows have one order");
}

}  // namespace
}  // namespace fde::bench
