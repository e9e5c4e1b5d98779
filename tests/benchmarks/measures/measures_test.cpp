// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/measures.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_statistics_double.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

double time_measure(std::string_view id, const std::vector<double>& seconds) {
  return std::ranges::find(time_measures(), id, &TimeMeasure::id)->value({.seconds = seconds}).value();
}

TEST(Measures, OfValuesBesideAReference) {
  const Rows values = (Rows(2, 3) << 1.0, 2.0, 3.0, 0.0, 0.0, 10.0).finished();
  const Rows reference = (Rows(2, 3) << 1.0, 4.5, 3.25, 0.0, 0.0, 9.0).finished();
  EXPECT_NEAR(mescd(values, reference), -std::log10(0.1), 1e-15);
  const std::vector<double> times{0.0, 1.0, 2.0};
  const auto error = [&](Norm norm, Scale scale) {
    return errors_of(norm, values, reference, divisors(scale, times, reference)).maxCoeff();
  };
  EXPECT_EQ(error(Norm::end, Scale::absolute), 1.0);
  EXPECT_EQ(error(Norm::maximum, Scale::absolute), 2.5);
  EXPECT_DOUBLE_EQ(error(Norm::end, Scale::relative), 1.0 / 9.0);
  EXPECT_DOUBLE_EQ(error(Norm::maximum, Scale::relative), 2.5 / 4.5);
  EXPECT_DOUBLE_EQ(error(Norm::end, Scale::mixed), 0.1);
  EXPECT_DOUBLE_EQ(error(Norm::maximum, Scale::mixed), 2.5 / 5.5);
}

// Errors as parts of the largest value do not depend on the unit; a column that is 0 has none.
TEST(PeakErrors, DoNotDependOnTheUnit) {
  const std::vector<double> times{0.0, 1.0, 2.0};
  const Rows reference = (Rows(2, 3) << 0.0, -4.8e-3, 1e-3, 0.0, 0.0, 0.0).finished();
  const Rows values = reference + (Rows(2, 3) << 0.0, 4.8e-4, 1e-4, 0.0, 1.0, 1.0).finished();
  for (const double unit : {1.0, 1e3, 1e-9}) {
    const Rows by = divisors(Scale::peak, times, unit * reference);
    EXPECT_NEAR(errors_of(Norm::maximum, unit * values, unit * reference, by).maxCoeff(), 0.1, 1e-12) << unit;
    EXPECT_NEAR(errors_of(Norm::end, unit * values, unit * reference, by).maxCoeff(), 1e-4 / 4.8e-3, 1e-12)
        << unit;
  }
}

// The size in [0.9 t, t] at t = 0.95 is 1, so the divisor is a thousandth of it. At t = 0 and t = 2 the
// reference is 0 in all of [0.9 t, t]: relative errors are left out.
TEST(RelativeErrors, TakeAZeroForAThousandthOfTheSizeNearby) {
  const std::vector<double> times{0.0, 0.9, 0.95, 2.0};
  const Rows reference = (Rows(1, 4) << 0.0, 1.0, 1e-6, 0.0).finished();
  const Rows by = divisors(Scale::relative, times, reference);
  EXPECT_EQ(by(0, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(by(0, 1), 1.0);
  EXPECT_EQ(by(0, 2), 1e-3);
  EXPECT_EQ(by(0, 3), std::numeric_limits<double>::infinity());
}

// |y - 0| is 1, 2, 4 and |y - y(0)| is 0, 1, 3; t = 0 is left out.
TEST(ConstantSolutionError, IsThatOfZeroOrOfTheInitialValue) {
  const Rows reference = (Rows(1, 3) << 1.0, 2.0, 4.0).finished(), one = Rows::Ones(1, 3);
  EXPECT_EQ(constant_solution_error(Norm::end, {0.0, 1.0, 2.0}, reference, one), 3.0);
  EXPECT_EQ(constant_solution_error(Norm::maximum, {0.0, 1.0, 2.0}, reference, one), 3.0);
  EXPECT_EQ(constant_solution_error(Norm::end, {0.5, 1.0, 2.0}, reference, one), 4.0);
}

TEST(ErrorKinds, HaveAMeasureAndAWordEach) {
  std::set<std::string_view> ids;
  for (const auto* measure : measures()) ids.insert(measure->id);
  for (const ErrorKind& kind : error_kinds) {
    EXPECT_TRUE(ids.contains(error_measure(kind))) << error_measure(kind);
    EXPECT_TRUE(ids.contains(baseline_measure(kind))) << baseline_measure(kind);
    EXPECT_EQ(parse_norm(name(kind.norm)), kind.norm);
    EXPECT_EQ(parse_scale(name(kind.scale)), kind.scale);
  }
  expect_message([] { parse_norm("start"); }, "norm = start: must be end or maximum");
  expect_message([] { parse_scale("log"); }, "scale = log: must be absolute, relative, mixed or peak");
}

TEST(Measures, OfTimes) {
  EXPECT_EQ(time_measure("time_minimum", {3.0, 1.0, 2.0}), 1.0);
  EXPECT_EQ(time_measure("time_median", {3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(time_measure("time_median", {3.0, 1.0, 10.0, 2.0}), 2.5);
}

// The median solve counts: one of the others may have waited for the processor.
TEST(Measures, OfTimesTellWhetherOtherWorkDisturbedThem) {
  const auto disturbed = [](std::vector<double> seconds, std::vector<double> waited) {
    const auto& measure = *std::ranges::find(time_measures(), "disturbed", &TimeMeasure::id);
    return measure.value({.seconds = std::move(seconds), .waited = std::move(waited)});
  };
  EXPECT_EQ(disturbed({0.100, 0.101, 0.102}, {0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(disturbed({0.100, 0.200, 0.101}, {0.0, 0.099, 0.0}), 0.0) << "one of three";
  EXPECT_EQ(disturbed({0.103, 0.200, 0.101}, {0.004, 0.099, 0.0}), 1.0) << "the median waited";
  EXPECT_EQ(disturbed({0.100, 0.112, 0.115}, {0.0, 0.0, 0.0}), 1.0) << "the quickest is far from the median";
  EXPECT_EQ(disturbed({1.0e-5, 1.3e-5, 1.4e-5}, {3e-6, 3e-6, 3e-6}), 0.0) << "the clock takes as long";
  EXPECT_EQ(disturbed({0.1}, {0.05}), 1.0);
  EXPECT_EQ(disturbed({0.1}, {}), std::nullopt) << "of another program it is not known";
}

TEST(TimingWatch, CountsWhatTheSystemTells) {
  const TimingWatch watch;
  const auto conditions = watch.conditions();
  EXPECT_TRUE(conditions.load.has_value());
  EXPECT_GE(conditions.switches, 0.0);
}

// The 8th and the 18th of 25 values enclose the median with 95 % probability (any table of the sign test).
TEST(MedianInterval, IsAnIntervalOfTheMedian) {
  std::vector<double> seconds(25);
  std::iota(seconds.rbegin(), seconds.rend(), 1.0);
  const auto [median, low, high, confidence] = spread_of(seconds);
  EXPECT_EQ(median, 13.0);
  EXPECT_EQ(low, 8.0);
  EXPECT_EQ(high, 18.0);
  EXPECT_EQ(confidence, 0.95);
  EXPECT_EQ(time_measure("time_low", {3.0, 1.0, 2.0}), 1.0) << "few tell no more than their limits";
  EXPECT_EQ(time_measure("time_high", {3.0, 1.0, 2.0}), 3.0);
  EXPECT_EQ(spread_of({3.0, 1.0, 2.0}).confidence, 0.75) << "three on one side of the median: 2 of 8 cases";
}

TEST(WatchedSteps, AreAllUpToALimitAndThenSpread) {
  EXPECT_EQ(comparison_steps(3), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(comparison_steps(8192).size(), 8193U);
  const auto some = comparison_steps(1'000'000'000);
  EXPECT_EQ(some.front(), 0);
  EXPECT_EQ(some[16], 16);
  EXPECT_EQ(some[17], 1'000'000'000 / 8192);
  EXPECT_EQ(some.back(), 1'000'000'000);
  EXPECT_EQ(comparison_times({.end = 0.75, .steps = 3}), (std::vector{0.0, 0.25, 0.5, 0.75}));
}

TEST(WatchedSteps, AreFewerWhereColumnsAreMany) {
  for (const auto& [columns, steps] : {std::pair{1, 8192}, {32, 8192}, {33, 4096}, {200, 1024}, {5000, 1024}})
    EXPECT_EQ(comparison_steps_for(static_cast<std::size_t>(columns)), steps) << columns;
}

// Whether the distances t - start include four values per power of ten from `least` to `most`.
bool meet_powers_of_ten(const std::vector<double>& times, double start, double least, double most) {
  for (double since = least; since < most; since *= 1.8) {
    const auto next = std::ranges::upper_bound(times, start + since);
    if (next == times.end() || *next - start > 1.8 * since) return false;
  }
  return true;
}

// The smallest order of a differential row is 1/2: t^(1/2) is at rounding for t = 1e-34. Near the jump
// at 1.25 the rounding of the time limits the distance.
TEST(WatchedTimes, OfAProblemLieCloserTowardsItsStartAndItsJumps) {
  const Problem problem{
      .components = {{0.5, {1.0}}, {0.0, {0.0}}, {1.5, {0.0, 0.0}}}, .end = 2.0, .jump_times = {1.25, 2.0}};
  const auto times = comparison_times(problem, 8);
  EXPECT_TRUE(std::ranges::is_sorted(times, std::less_equal<>())) << "none is there twice";
  for (int i = 0; i <= 8; ++i) EXPECT_TRUE(std::ranges::binary_search(times, 0.25 * i)) << i;
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 2.0);
  EXPECT_GE(times[1], 2e-34);
  EXPECT_TRUE(meet_powers_of_ten(times, 0.0, 2e-34, 0.5));
  EXPECT_TRUE(meet_powers_of_ten(times, 1.25, 2e-6, 0.5));
  EXPECT_FALSE(meet_powers_of_ten(times, 1.25, 1e-8, 0.5));
  EXPECT_FALSE(meet_powers_of_ten(times, 1.5, 2e-6, 0.5)) << "nothing begins there";
}

TEST(Measures, ANumberWithoutErrorHasSeventeenDigits) {
  EXPECT_EQ(mescd(Rows::Ones(1, 3), Rows::Ones(1, 3)), 17.0);
}

// The residual of the energy balance along a given path.
std::optional<double> residual(const Energy& energy, const Trajectory& path) {
  EnergyObserver balance(energy);
  for (Eigen::Index n = 0; n < path.y.cols(); ++n) {
    balance.observe(path.time(n), path.y.col(n));
  }
  return balance.residual();
}

TEST(EnergyResidual, VanishesWithTheScheme) {
  const auto scene = scene_of("pendulum");
  const auto of = [&](int steps) {
    return residual(scene.energy, solve("product_trapezoidal", scene.problem, steps)).value();
  };
  EXPECT_LT(of(4096), 1e-4);
  EXPECT_GT(std::log2(of(1024) / of(2048)), 1.4);
}

TEST(EnergyResidual, IsTheDriftOfAConservedEnergy) {
  const auto scene = scene_of("pendulum", {{"mu", 0.0}, {"lambda", 0.0}, {"nu", 0.0}});
  const auto path = solve("l1", scene.problem, 500);
  double drift = 0.0;
  for (const auto& y : path.y.colwise())
    drift = std::max(drift, std::abs(scene.energy.value(Vec(y)) - scene.energy.value(path.y.col(0))));
  EXPECT_DOUBLE_EQ(residual(scene.energy, path).value(), drift);
}

// E = t^3 has the power 3 t^2, a parabola, also at times that are not equally spaced.
TEST(EnergyResidual, IsExactForAParabolicPower) {
  const Energy cubic{.value = [](In y) { return y[0] * y[0] * y[0]; },
                     .power = [](double t, In) { return 3.0 * t * t; }};
  Trajectory path{.times = comparison_times({2.0, 40, 1.7})};
  path.y = Eigen::Map<const Eigen::RowVectorXd>(path.times.data(), 41);
  EXPECT_LT(residual(cubic, path).value(), 1e-14);
}

TEST(EnergyResidual, NeedsThreeSteps) {
  const auto scene = scene_of("pendulum");
  EXPECT_FALSE(residual(scene.energy, solve("l1", scene.problem, 1)).has_value());
  EXPECT_TRUE(residual(scene.energy, solve("l1", scene.problem, 2)).has_value());
}

TEST(EnergyResidual, OfAnInfiniteEnergyIsNotZero) {
  const auto scene = scene_of("pendulum");
  auto path = solve("l1", scene.problem, 8);
  path.y(2, 4) = 1e200;
  EXPECT_FALSE(std::isfinite(residual(scene.energy, path).value()));
}

TEST(FitRate, RecoversAPowerLaw) {
  std::vector<ErrorSample> points;
  for (int k = 0; k < 6; ++k) points.push_back({std::pow(2.0, -k), 3.0 * std::pow(2.0, -1.25 * k)});
  const Fit fit = fit_rate(points);
  EXPECT_NEAR(fit.slope, 1.25, 1e-14);
  EXPECT_NEAR(fit.correlation, 1.0, 1e-14);
  EXPECT_EQ(fit.points, 6U);
}

TEST(FitRate, StopsAtRounding) {
  const std::vector<ErrorSample> points{
      {1, 1e-6}, {0.1, 1e-8}, {0.01, 1e-10}, {0.001, 3e-13}, {0.0001, 2e-13}};
  EXPECT_NEAR(fit_rate(points).slope, 2.0, 1e-12);
  EXPECT_EQ(fit_rate(points).points, 3U);
  EXPECT_EQ(fit_rate(std::span(points).first(2)).points, 0U);
}

// Comparisons with GSL, which shares no code with fdebench.

TEST(FitRate, IsGslsLineAndCorrelation) {
  std::mt19937_64 random(39);
  std::normal_distribution<double> scatter;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<ErrorSample> points;
    std::vector<double> x, y;
    for (int k = 0; k < 3 + trial % 20; ++k) {
      points.push_back({std::exp2(-k), std::exp(scatter(random))});
      x.push_back(std::log(points.back().h));
      y.push_back(std::log(points.back().error));
    }
    double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, &c00, &c01, &c11, &residual);
    const Fit fit = fit_rate(points);
    EXPECT_EQ(fit.points, x.size());
    EXPECT_NEAR(fit.slope, slope, 1e-14);
    EXPECT_NEAR(fit.correlation, gsl_stats_correlation(x.data(), 1, y.data(), 1, x.size()), 1e-14);
  }
}

// Solves a problem of integer orders by GSL's Runge-Kutta-Prince-Dormand (8,9).
Vec integrate_by_gsl(const Problem& problem) {
  const auto function = [](double t, const double* y, double* f, void* data) {
    const auto& of = *static_cast<const Problem*>(data);
    Eigen::Map<Vec> out(f, of.size());
    of.rhs(t, Eigen::Map<const Vec>(y, of.size()), out);
    return static_cast<int>(GSL_SUCCESS);
  };
  auto copy = problem;
  gsl_odeiv2_system system{function, nullptr, copy.components.size(), &copy};
  auto* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4, 1e-13, 1e-13);
  Vec y = taylor_part(problem, 0.0);
  double t = 0.0;
  EXPECT_EQ(gsl_odeiv2_driver_apply(driver, &t, problem.end, y.data()), GSL_SUCCESS);
  gsl_odeiv2_driver_free(driver);
  return y;
}

class WholeOrders : public testing::TestWithParam<std::string> {
 protected:
  static Scene scene() {
    Scene scene = GetParam() == "brusselator" ? scene_of("brusselator", {{"gamma", 1.0}})
                                              : scene_of(GetParam(), {{"alpha", 1.0}, {"beta", 0.0}});
    scene.problem.end = 5.0;
    return scene;
  }
};

TEST_P(WholeOrders, TheReferenceIsGslsRungeKuttaSolution) {
  EXPECT_LT((reference_of(scene()).at(5.0).value -
             columns_at(scene().outputs, 5.0, integrate_by_gsl(scene().problem)))
                .cwiseAbs()
                .maxCoeff(),
            2e-11);
}

TEST_P(WholeOrders, EverySchemeTendsToGslsSolution) {
  const Vec exact = integrate_by_gsl(scene().problem);
  for (const auto* scheme : grid_schemes()) {
    if (unsupported_reason(*scheme, scene().problem, Grid{5.0, 4000})) continue;
    const auto error = [&](int steps) {
      return (solve(scheme->id, scene().problem, steps).y.rightCols(1) - exact).cwiseAbs().maxCoeff();
    };
    const double expected = scheme->expected_rate(scene().problem, scene().smoothness, 1.0, Norm::end);
    // Schemes with a high rate reach the error of GSL's solution at these numbers of steps.
    constexpr double of_gsl = 2e-11;
    const double coarse = error(4000), fine = error(8000);
    if (coarse < 100.0 * of_gsl) {
      EXPECT_LT(fine, 100.0 * of_gsl) << scheme->id;
    } else {
      EXPECT_NEAR(std::log2(coarse / fine), expected, 0.1) << scheme->id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, WholeOrders, testing::Values("pendulum", "extensible_pendulum", "brusselator"),
                         text_of_param);

// J^(1-beta) of phi', by GSL's quadrature for algebraic endpoint singularities, equals the chain's D^beta
// phi.
TEST(GslQuadrature, OfThePendulumsVelocityIsItsFractionalDerivative) {
  const double beta = 0.5, t = 3.0;
  const auto scene = scene_of("pendulum");
  const reference::Reference reference = reference_of(scene);
  struct Data {
    const reference::Reference& reference;
  } data{reference};
  gsl_function velocity{[](double s, void* d) { return static_cast<Data*>(d)->reference.at(s).value[2]; },
                        &data};
  auto* table = gsl_integration_qaws_table_alloc(0.0, -beta, 0, 0);
  auto* workspace = gsl_integration_workspace_alloc(1000);
  double integral = 0.0, estimate = 0.0;
  ASSERT_EQ(
      gsl_integration_qaws(&velocity, 0.0, t, table, 1e-12, 1e-11, 1000, workspace, &integral, &estimate),
      GSL_SUCCESS);
  gsl_integration_workspace_free(workspace);
  gsl_integration_qaws_table_free(table);
  EXPECT_NEAR(integral / std::tgamma(1.0 - beta), reference.at(t).value[1], 1e-10);
}

}  // namespace
}  // namespace fde::bench
