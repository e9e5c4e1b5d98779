// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "support/message_of.hpp"
#include "support/refusal_of.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;

// The exact columns of a scene at these times, as measurements without noise.
ExternalTrajectory exact_measurements(const SceneVariant& of, std::vector<Eigen::Index> columns,
                                      std::vector<double> times) {
  const Scene scene = make_scene(of);
  MemoizedReference reference(scene, columns);
  const Rows values = reference.at(times);
  return {.columns = std::move(columns), .times = std::move(times), .values = values};
}

std::vector<double> even_times(double end, int count) {
  std::vector<double> times;
  for (int i = 1; i <= count; ++i) times.push_back(end * i / count);
  return times;
}

void add_noise(ExternalTrajectory& measured, Eigen::Index row, double deviation, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, deviation);
  for (double& value : measured.values.row(row)) value += noise(random);
}

// The data of a request that has these already.
auto given(const ExternalTrajectory& data) {
  return [data](const Scene& /*scene*/) { return data; };
}

FitRequest request_for(const std::string& scene, std::vector<VariedParameter> vary,
                       const ExternalTrajectory& data) {
  return {.variant = read_variant(scene, {}), .vary = std::move(vary), .data = given(data)};
}

// The creep of a fractional Zener element with noise of a hundredth of its size, 200 times over: intervals of
// 95 % have the true parameters in 95 % of the fits, to three standard deviations of that count, with the
// deviations given and with deviations that are estimated.
TEST(Fits, HaveIntervalsThatHoldTheTruth) {
  const SceneRegistry files = with_equation_files(built_in_scenes());
  const auto file = example("fit/creep.toml");
  const auto truth = read_variant(file, {"alpha=0.6", "E0=1.2", "E1=2.5", "tau=1"}, files);
  const auto exact = exact_measurements(truth, {0}, [] {
    auto times = even_times(1.0, 60);
    for (double& t : times) t = 20.0 * t * t;
    return times;
  }());
  constexpr int repetitions = 200;
  constexpr double sd = 0.004;
  std::mt19937 random(1);
  for (const bool is_given : {true, false}) {
    std::map<std::string, int> held;
    for (int i = 0; i < repetitions; ++i) {
      auto noisy = exact;
      add_noise(noisy, 0, sd, random);
      if (is_given) noisy.deviations = Rows::Constant(1, noisy.values.cols(), sd);
      const FittedScene fitted = fit({.variant = read_variant(file, {}, files),
                                      .vary = {{"alpha"}, {"E0"}, {"E1"}, {"tau"}},
                                      .data = given(noisy)});
      for (const FittedParameter& one : fitted.parameters) {
        const double true_value = std::get<double>(truth.values.at(one.name));
        held[one.name] += one.low <= true_value && true_value <= one.high ? 1 : 0;
        EXPECT_LE(one.solver_error, 0.01 * one.standard_error);
      }
    }
    for (const auto& [name, count] : held) {
      EXPECT_GE(count, 0.9 * repetitions) << name << is_given;
      EXPECT_LE(count, 0.995 * repetitions) << name << is_given;
    }
  }
}

// y = y0 E(t) is linear in y0: by the normal equation y0 = sum(m y) / sum(m^2), with the variance
// s^2 / sum(m^2), where s^2 is what is left by the number of measurements less one.
TEST(Fits, OfALinearParameterSolveTheNormalEquation) {
  auto data = exact_measurements(read_variant("relaxation:y0=1", {}), {0}, even_times(1.0, 12));
  const Vec m = data.values.row(0);
  std::mt19937 random(2);
  data.values *= 2.5;
  add_noise(data, 0, 0.1, random);
  const Vec y = data.values.row(0);
  const double y0 = m.dot(y) / m.squaredNorm();
  const double variance = (y - y0 * m).squaredNorm() / 11.0;
  const auto fitted = fit(request_for("relaxation", {{"y0"}}, data));
  EXPECT_NEAR(fitted.parameters[0].value, y0, 1e-7);
  EXPECT_NEAR(fitted.parameters[0].standard_error, std::sqrt(variance / m.squaredNorm()), 1e-7);
  EXPECT_NEAR(fitted.parameters[0].high - fitted.parameters[0].value,
              2.200985160 * fitted.parameters[0].standard_error, 1e-7);  // Student's t of 11 degrees, 0.975
  EXPECT_NEAR(fitted.deviations(0, 0), std::sqrt(variance), 1e-7);
}

// A weight of 1/sd^2 is as many measurements; a missing one is none; equal times may repeat.
TEST(Fits, WeighMeasurementsByTheirDeviations) {
  const auto at = [](std::vector<double> times, std::vector<double> values, std::vector<double> deviations) {
    ExternalTrajectory data{.columns = {0}, .times = std::move(times)};
    data.values = Eigen::Map<const Matrix>(values.data(), 1, std::ssize(values));
    data.deviations = Eigen::Map<const Matrix>(deviations.data(), 1, std::ssize(deviations));
    return data;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto four = fit(
      request_for("relaxation", {{"gamma"}},
                  at({0.2, 0.5, 0.5, 0.5, 0.5, 1.0}, {0.7, 0.5, 0.5, 0.5, 0.5, 0.4}, {1, 1, 1, 1, 1, 1})));
  const auto heavy = fit(request_for("relaxation", {{"gamma"}},
                                     at({0.2, 0.5, 0.7, 1.0}, {0.7, 0.5, nan, 0.4}, {1, 0.5, nan, 1})));
  EXPECT_NEAR(four.parameters[0].value, heavy.parameters[0].value, 1e-7);
  EXPECT_NEAR(four.parameters[0].standard_error, heavy.parameters[0].standard_error, 1e-6);
  EXPECT_EQ(heavy.chi_squared.degrees, 2);
  EXPECT_EQ(heavy.misfits[0].count, 3);
}

// Of two columns in different units, with noise of another size each, both deviations are found.
TEST(Fits, EstimateADeviationForEachColumn) {
  const auto truth = read_variant("pendulum:alpha=1.7,beta=0.6", {});
  auto data = exact_measurements(truth, {0, 2}, even_times(20.0, 400));
  std::mt19937 random(3);
  add_noise(data, 0, 0.01, random);
  add_noise(data, 1, 0.2, random);
  const auto fitted = fit(request_for("pendulum", {{"alpha"}, {"beta"}}, data));
  EXPECT_NEAR(fitted.deviations(0, 0), 0.01, 0.0015);  // four standard deviations of 0.01 / sqrt(2 * 400)
  EXPECT_NEAR(fitted.deviations(1, 0), 0.2, 0.03);
  for (const FittedParameter& one : fitted.parameters)
    EXPECT_NEAR(one.value, one.name == "alpha" ? 1.7 : 0.6, 4.0 * one.standard_error);
}

// The estimate by a scheme with larger errors is moved by what it says, against one that is exact.
TEST(Fits, SayHowFarTheSolverMovesThem) {
  auto data = exact_measurements(read_variant("relaxation:gamma=0.7", {}), {0}, even_times(1.0, 10));
  std::mt19937 random(4);
  add_noise(data, 0, 0.01, random);
  auto request = request_for("relaxation", {{"gamma"}}, data);
  const double exact = fit(request).parameters[0].value;
  request.scheme = "adaptive_pc";
  const auto fitted = fit(request).parameters[0];
  EXPECT_GT(fitted.solver_error, 1e-10);
  EXPECT_NEAR(std::abs(fitted.value - exact) / fitted.solver_error, 1.0, 0.2);
}

// Without a reference the solver error is by a run with a smaller tolerance. It is that by the reference, and
// the tolerance is lowered as far: here until the solver error is small against noise of 1e-7.
TEST(Fits, KnowTheSolverErrorWithoutAReference) {
  SceneFactory factory = *read_variant("relaxation", {}).factory;
  auto data = exact_measurements({&factory, {{"gamma", 0.7}}}, {0}, even_times(1.0, 10));
  std::mt19937 random(9);
  add_noise(data, 0, 1e-7, random);
  const auto fitted = [&] {
    return fit({.variant = {&factory}, .vary = {{"gamma"}}, .data = given(data), .scheme = "adaptive_pc"});
  };
  const auto known = fitted();
  factory.make = [with_reference = factory.make](const Parameters& values) {
    Scene scene = with_reference(values);
    scene.name.clear();
    scene.reference = {
        .at = [](double) -> reference::ReferenceValue { throw std::runtime_error("there is none"); }};
    return scene;
  };
  const auto unknown = fitted();
  EXPECT_TRUE(known.by_reference);
  EXPECT_FALSE(unknown.by_reference);
  EXPECT_LT(known.accuracy, 1e-9);
  EXPECT_EQ(unknown.accuracy, known.accuracy);
  EXPECT_NEAR(unknown.parameters[0].solver_error / known.parameters[0].solver_error, 1.0, 0.3);
}

// nu = 0 takes the term of order beta out of the equation; of E0 and a load that scales with it no ratio is
// known.
TEST(Fits, NameWhatTheMeasurementsDoNotDetermine) {
  const auto data = exact_measurements(read_variant("pendulum:nu=0", {}), {0}, even_times(20.0, 30));
  EXPECT_THAT(message_of<NumericalFailure>([&] {
                fit(request_for("pendulum:nu=0", {{"alpha"}, {"beta"}}, data));
              }),
              HasSubstr("do not determine beta"));
  const SceneFactory factory = maker_of(
      "end = 1\n[parameters]\na = 1\nb = 2\ng = 0.5\n[unknown.x]\norder = \"g\"\nrhs = \"-a*b*x\"\ninitial = "
      "[1]\n");
  const auto decay = exact_measurements({&factory}, {0}, even_times(1.0, 10));
  EXPECT_THAT(message_of<NumericalFailure>([&] {
                fit({.variant = {&factory}, .vary = {{"a"}, {"g"}, {"b"}}, .data = given(decay)});
              }),
              HasSubstr("do not determine a, b"));
}

// The order of a file without a range starts far off; trials that the scene refuses, orders above 1 with one
// initial value, are rejected.
TEST(Fits, GoBackFromParametersThatTheSceneRefuses) {
  const SceneFactory factory = maker_of(
      "end = 1\n[parameters]\ng = 0.2\nk = 9\n[unknown.x]\norder = \"g\"\nrhs = \"-k*x\"\ninitial = [1]\n");
  const auto data = exact_measurements({&factory, {{"g", 0.97}, {"k", 1.5}}}, {0}, even_times(1.0, 20));
  const auto fitted = fit({.variant = {&factory}, .vary = {{"g"}, {"k"}}, .data = given(data)});
  EXPECT_NEAR(fitted.parameters[0].value, 0.97, 1e-8);
  EXPECT_NEAR(fitted.parameters[1].value, 1.5, 1e-8);
}

// The least sum of squares within the limits is at one: the others are fitted with that value.
TEST(Fits, FixParametersAtLimitsAndFitTheOthers) {
  auto data =
      exact_measurements(read_variant("relaxation:gamma=0.8,lambda=-2", {}), {0}, even_times(1.0, 20));
  std::mt19937 random(5);
  add_noise(data, 0, 0.005, random);
  const auto limited =
      fit(request_for("relaxation", {{.name = "gamma", .low = 0.2, .high = 0.7}, {"lambda"}}, data));
  const auto fixed = fit(request_for("relaxation:gamma=0.7", {{"lambda"}}, data));
  EXPECT_TRUE(limited.parameters[0].is_at_limit);
  EXPECT_EQ(limited.parameters[0].value, 0.7);
  EXPECT_FALSE(limited.parameters[1].is_at_limit);
  EXPECT_NEAR(limited.parameters[1].value, fixed.parameters[0].value, 1e-6);
  EXPECT_NEAR(limited.parameters[1].standard_error, fixed.parameters[0].standard_error,
              0.1 * fixed.parameters[0].standard_error);
}

// An order of 1 is an end of its range: a fit may start there and may end there.
TEST(Fits, StartAndEndAtAnIntegerOrder) {
  auto data = exact_measurements(read_variant("van_der_pol:gamma=1,until=5", {}), {0}, even_times(5.0, 30));
  const auto fitted = fit(request_for("van_der_pol:gamma=1,until=5", {{"gamma"}, {"mu"}}, data));
  EXPECT_NEAR(fitted.parameters[0].value, 1.0, 1e-6);
  EXPECT_FALSE(fitted.parameters[1].is_at_limit);  // in [0, 1e6]
}

// The same relaxation, with noise of 0.005.
ExternalTrajectory noisy_relaxation() {
  auto data =
      exact_measurements(read_variant("relaxation:gamma=0.8,lambda=-2", {}), {0}, even_times(1.0, 20));
  std::mt19937 random(6);
  add_noise(data, 0, 0.005, random);
  return data;
}

void expect_equal(const FittedScene& a, const FittedScene& b, const std::string& of) {
  for (std::size_t j = 0; j < a.parameters.size(); ++j) {
    const double error = b.parameters[j].standard_error;
    EXPECT_NEAR(a.parameters[j].value, b.parameters[j].value, 1e-4 * error) << of << j;
    EXPECT_NEAR(a.parameters[j].standard_error, error, 1e-3 * error) << of << j;
  }
}

// Estimate and standard error do not depend on where a fit starts, by factors of hundreds, nor on how a
// parameter is limited.
TEST(Fits, DoNotDependOnTheirStart) {
  const auto data = noisy_relaxation();
  const auto near = fit(request_for("relaxation", {{"gamma"}, {"lambda"}}, data));
  for (const std::string start :
       {"relaxation:lambda=-1000", "relaxation:gamma=1.5,lambda=-0.3", "relaxation:gamma=0.3,lambda=-9"})
    expect_equal(fit(request_for(start, {{"gamma"}, {"lambda"}}, data)), near, start);
  expect_equal(fit(request_for("relaxation:lambda=-0.1", {{"gamma"}, {.name = "lambda", .high = 0.0}}, data)),
               near, "below 0");
}

// In other units all of a fit is the same but the parameter that has them.
TEST(Fits, DoNotDependOnUnits) {
  auto data = noisy_relaxation();
  const auto near = fit(request_for("relaxation:y0=0.5", {{"gamma"}, {"lambda"}, {"y0"}}, data));
  for (const auto& [unit, start] :
       {std::pair(1e9, "relaxation:y0=5e8"), std::pair(1e-12, "relaxation:y0=5e-13")}) {
    auto scaled = data;
    scaled.values *= unit;
    auto far = fit(request_for(start, {{"gamma"}, {"lambda"}, {"y0"}}, scaled));
    far.parameters[2].value /= unit;
    far.parameters[2].standard_error /= unit;
    expect_equal(far, near, start);
  }
}

// Columns are found by their names: of order above 1 the file has D(x,1), and a coefficient that starts at 0
// takes a column away.
TEST(Fits, FindTheirColumnsWhereTheseDependOnParameters) {
  const SceneFactory factory = maker_of(
      "end = 2\n[parameters]\nq = 1.5\nk = 1\n[unknown.x]\norder = \"q\"\nrhs = \"-k*x\"\ninitial = [1, "
      "0]\n");
  const SceneVariant truth{&factory, {{"q", 1.7}, {"k", 2.0}}};
  const auto names = make_scene(truth).outputs.names;
  const auto data =
      exact_measurements(truth, {std::ranges::find(names, "D(x,1)") - names.begin()}, even_times(2.0, 20));
  const auto fitted = fit({.variant = {&factory}, .vary = {{"q"}, {"k"}}, .data = given(data)});
  EXPECT_EQ(fitted.names, std::vector<std::string>{"D(x,1)"});
  EXPECT_NEAR(fitted.parameters[0].value, 1.7, 1e-7);
  EXPECT_NEAR(fitted.parameters[1].value, 2.0, 1e-7);
}

// One measurement of a column is fitted exactly by a parameter that only it depends on.
TEST(Fits, RefuseAColumnWhoseDeviationVanishes) {
  const SceneFactory factory = maker_of(
      "end = 1\n[parameters]\na = 1\nb = 1\n[unknown.x]\norder = 0.5\nrhs = \"-a*x\"\ninitial = [1]\n"
      "[unknown.y]\norder = 0.5\nrhs = \"-b*y\"\ninitial = [1]\n");
  auto data = exact_measurements({&factory, {{"a", 2.0}, {"b", 0.5}}}, {0, 1}, even_times(1.0, 12));
  std::mt19937 random(8);
  add_noise(data, 0, 0.01, random);
  add_noise(data, 1, 0.01, random);
  data.values.row(1).head(11).setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(message_of<NumericalFailure>([&] {
                fit({.variant = {&factory}, .vary = {{"a"}, {"b"}}, .data = given(data)});
              }),
              HasSubstr("column y is fitted exactly"));
}

TEST(Fits, NameTheFieldThatTheyRefuse) {
  const auto data = exact_measurements(read_variant("relaxation", {}), {0}, {0.5, 1.0});
  const auto refused = [&](const std::string& scene, std::vector<VariedParameter> vary) {
    return refusal_of([&] { fit(request_for(scene, std::move(vary), data)); });
  };
  EXPECT_EQ(refused("relaxation", {}), "<vary> = : must be one parameter at least");
  EXPECT_THAT(refused("relaxation", {{"gama"}}),
              HasSubstr("<vary>: gama: scene relaxation has no such parameter"));
  EXPECT_EQ(refused("relaxation", {{"gamma"}, {"gamma"}}),
            "<vary> = gamma: must be a parameter that is named once");
  EXPECT_THAT(refused("pendulum", {{"alpha"}, {"beta"}, {"mu"}}),
              HasSubstr("<data>: has 2 of at least 4 measurements"));
  EXPECT_THAT(refused("relaxation", {{.name = "gamma", .low = 0.6}}), HasSubstr("starts in its range"));
  EXPECT_THAT(refused("fractional_constraint_2d", {{"formulation"}}), HasSubstr("one number"));
  auto request = request_for("relaxation", {{"gamma"}}, data);
  request.confidence = 1.0;
  EXPECT_EQ(refusal_of([&] { fit(request); }), "<confidence> = 1: must be a number in (0, 1)");
  request = request_for("relaxation", {{"gamma"}}, data);
  request.scheme = "l1";
  EXPECT_THAT(refusal_of([&] { fit(request); }),
              HasSubstr("<scheme> = l1: must be one with adaptive step size"));
  request = request_for("fractional_extremum:form=whole", {{"alpha"}}, data);
  EXPECT_THAT(refusal_of([&] { fit(request); }),
              HasSubstr("no scheme with adaptive step size takes the scene"));
}

}  // namespace
}  // namespace fde::bench
