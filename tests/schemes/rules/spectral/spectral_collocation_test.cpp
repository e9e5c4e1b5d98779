// SPDX-License-Identifier: MIT
// Spectral collocation: the accuracy for a given tolerance, and how runs end that cannot finish.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

const Scheme& scheme() { return *find_scheme("spectral_collocation"); }

Trajectory run(const Problem& problem, double accuracy, const Options& options = {}) {
  return scheme().solve(problem, Tolerance{accuracy, accuracy}, options);
}

struct SpectralRun {
  std::string scene;
  ParameterValues values{};
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const SpectralRun& asked, std::ostream* out) {
  *out << SceneVariant{&scene_maker(asked.scene), asked.values}.label();
}

// With the constraint as an algebraic row; alpha is the order of the scene's memory term, if it has one.
SpectralRun multiplier(const std::string& scene, std::optional<double> alpha = {}) {
  SpectralRun asked{scene, {{"formulation", "multiplier"}}};
  if (alpha) asked.values["alpha"] = *alpha;
  return asked;
}

class Spectral : public testing::TestWithParam<SpectralRun> {};

// At the run's own times, the first of which are close to a singular start.
TEST_P(Spectral, DeliversTheAccuracy) {
  const Scene scene = scene_of(GetParam().scene, GetParam().values);
  const auto reference = reference_of(scene);
  for (const double accuracy : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto path = run(scene.problem, accuracy);
    ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
    EXPECT_EQ(path.last_time, scene.problem.end);
    EXPECT_EQ(path.steps, std::ssize(path.times) - 1);
    for (std::size_t i = 1; i < path.times.size(); i += 1 + path.times.size() / 64) {
      const double t = path.times[i];
      const auto exact = reference.at(t);
      const Vec columns = columns_at(scene.outputs, t, path.y.col(static_cast<Eigen::Index>(i)));
      for (Eigen::Index c = 0; c < columns.size(); ++c) {
        EXPECT_LT(std::abs(columns[c] - exact.value[c]),
                  accuracy * (1.0 + std::abs(exact.value[c])) + 4.0 * exact.bound[c])
            << accuracy << ' ' << t;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    SceneRegistry, Spectral,
    testing::Values(
        SpectralRun{"relaxation"}, SpectralRun{"relaxation", {{"gamma", 0.1}}},
        SpectralRun{"relaxation", {{"gamma", 1.7}}}, SpectralRun{"relaxation", {{"gamma", 1.0}}},
        SpectralRun{"relaxation", {{"lambda", 20.0}}}, SpectralRun{"relaxation_pair"},
        SpectralRun{"power", {{"gamma", 0.2}, {"p", 0.3}}}, SpectralRun{"diethelm"},
        SpectralRun{"linear_system"}, SpectralRun{"fractional_oscillator"}, SpectralRun{"damped_oscillator"},
        SpectralRun{"pendulum"}, SpectralRun{"extensible_pendulum"}, SpectralRun{"multi_term"},
        SpectralRun{"brusselator"}, SpectralRun{"van_der_pol", {{"mu", 1e4}}}, SpectralRun{"robertson"},
        SpectralRun{"stiff_relaxation", {{"lambda", -1e8}}}, SpectralRun{"fractional_constraint_2d"},
        SpectralRun{"knife_edge"}, SpectralRun{"canonical_ensemble"}, SpectralRun{"fractional_knife_edge"},
        multiplier("nonholonomic_particle"), multiplier("blade_on_sphere"), multiplier("isokinetic"),
        multiplier("fractional_constraint_2d", 0.8), multiplier("fractional_constraint_nonlinear", 0.3),
        multiplier("fractional_knife_edge", 0.8)),
    [](const auto& test) {
      auto name = testing::PrintToString(test.param);
      std::ranges::replace_if(
          name, [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

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

// D^0.5 y = 1, and 2 where y > 1, which is reached at pi/4: y = (2 sqrt t + 2 sqrt(t - pi/4)) / sqrt pi.
TEST(SpectralSwitch, IsLocatedToRounding) {
  const Problem problem{.components = {{0.5, {0.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = y[0] > 1.0 ? 2.0 : 1.0; },
                        .end = 2.0,
                        .switching_functions = {[](double, In y) { return y[0] - 1.0; }}};
  const std::vector<double> at{0.5, 0.785, 0.786, 1.0, 2.0};
  for (const double accuracy : {1e-3, 1e-6, 1e-12}) {
    const auto path = run(problem, accuracy, {.output_times = at});
    ASSERT_EQ(path.times, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double behind = std::max(0.0, at[i] - std::numbers::pi / 4.0);
      const double exact = 2.0 * (std::sqrt(at[i]) + std::sqrt(behind)) * std::numbers::inv_sqrtpi;
      EXPECT_NEAR(path.y(0, static_cast<Eigen::Index>(i)), exact, std::max(accuracy, 1e-11)) << at[i];
    }
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
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    const double t = path.times[i];
    double exact = response(t);
    for (int k = 1; k * std::numbers::pi / 50.0 < t; ++k)
      exact += (k % 2 == 0 ? 2.0 : -2.0) * response(t - k * std::numbers::pi / 50.0);
    EXPECT_NEAR(path.y(0, static_cast<Eigen::Index>(i)), exact, 10.0 * accuracy) << t;
  }
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

TEST(SpectralOrders, UncoupledRowsAreSolvedAsAlone) {
  const auto decay = [](double order) {
    return Component{order, order > 1.0 ? std::vector{1.0, 0.0} : std::vector{1.0}};
  };
  const Problem both{.components = {decay(0.4), decay(1.6)}, .rhs = [](double, In y, Out f) { f = -y; }};
  const auto path = run(both, 1e-10, {.output_times = {1.0}});
  EXPECT_NEAR(path.y(0, 0), reference::mittag_leffler(0.4, 1.0, -1.0), 1e-10);
  EXPECT_NEAR(path.y(1, 0), reference::mittag_leffler(1.6, 1.0, -1.0), 1e-10);
}

TEST(SpectralOrders, ConstantsAreExact) {
  for (const double order : {0.2, 0.5, 1.0, 1.5, 2.0}) {
    const Problem problem{.components = {{order, order > 1.0 ? std::vector{3.25, 0.0} : std::vector{3.25}}},
                          .rhs = [](double, In, Out f) { f.setZero(); }};
    EXPECT_EQ((run(problem, 1e-6).y.array() - 3.25).abs().maxCoeff(), 0.0) << order;
  }
}

// Without gravity the blade rotates in place: rows that are 0 do not affect the error test.
TEST(SpectralOrders, NonlinearRowsRestAtZero) {
  const auto path = run(scene_of("knife_edge", {{"g", 0.0}}).problem, 1e-6);
  ASSERT_EQ(path.status, SolveStatus::finished);
  const Vec end = path.y.rightCols<1>();
  EXPECT_EQ(end.head<2>(), Vec::Zero(2));
  EXPECT_NEAR(end[2], 10.0, 1e-6);
}

// For order 1: y' = y^2, y(0) = 1, y = 1 / (1 - t).
TEST(SpectralEnd, IsBeforeABlowUp) {
  for (const double order : {0.5, 1.0}) {
    const Problem problem{
        .components = {{order, {1.0}}}, .rhs = [](double, In y, Out f) { f = y.cwiseAbs2(); }, .end = 2.0};
    const auto path = run(problem, 1e-8);
    EXPECT_NE(path.status, SolveStatus::finished) << order;
    EXPECT_LE(path.last_time, 1.0 + 1e-7) << order;
    EXPECT_TRUE(path.y.allFinite());
  }
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

TEST(SpectralEnd, IsAtTheEdgeOfTheDomain) {
  Problem problem{
      .components = {{1.0, {1.0}}}, .rhs = [](double, In y, Out f) { f[0] = -1.0 / y[0]; }, .end = 2.0};
  problem.domain = {"y = 0", [](double, In y) { return y[0]; }};
  const auto path = run(problem, 1e-8);
  EXPECT_EQ(path.status, SolveStatus::left_domain);
  EXPECT_NEAR(path.last_time, 0.5, 1e-3);  // y = sqrt(1 - 2t)
}

TEST(SpectralEnd, IsThatOfTheBudget) {
  const Scene scene = scene_of("brusselator");
  EXPECT_EQ(run(scene.problem, 1e-12, {.budget = 0.0}).status, SolveStatus::out_of_budget);
}

TEST(SpectralRefusal, SaysWhatItDoesNotTake) {
  const Tolerance accuracy{1e-6, 1e-6};
  const auto reason = [&](const Problem& problem) {
    return unsupported_reason(scheme(), problem, accuracy).value_or("");
  };
  EXPECT_EQ(reason(scene_of("fractional_diffusion").problem), "takes dense Jacobians only");
  EXPECT_THAT(reason(scene_of("fractional_hamilton").problem), testing::HasSubstr("right derivative"));
  EXPECT_EQ(unsupported_reason(scheme(), scene_of("relaxation").problem, Grid{1.0, 8}),
            "takes an accuracy, not a grid");
}

}  // namespace
}  // namespace fde::bench
