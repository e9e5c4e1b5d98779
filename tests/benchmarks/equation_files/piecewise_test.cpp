// SPDX-License-Identifier: MIT
// Equations with jumps and kinks: functions of the unknowns make them nonlinear, functions of t give jumps at
// known times. The reference of an equation file is checked against schemes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::DoubleEq;

std::vector<double> jumps_of(const std::string& rhs, double end) {
  Scene scene = scene_of_text(relaxation_file(rhs));
  set_end(scene, end);
  return scene.problem.jump_times;
}

// The derivatives of all of these are constant wherever they exist.
TEST(Piecewise, FunctionsOfUnknownsAreNotLinear) {
  for (const auto* rhs : {"1 + step(x - 1)", "-sign(x)", "-x - sign(2*x - t)", "step(step(x))"})
    EXPECT_FALSE(is_linear(scene_of_text(relaxation_file(rhs)).problem)) << rhs;
  for (const auto* rhs : {"abs(x)", "min(x, 1)", "max(x, t) - x", "floor(x)", "-ceil(x - t)", "mod(x, 2)"})
    EXPECT_FALSE(is_linear(scene_of_text(relaxation_file(rhs)).problem)) << rhs;
}

TEST(Piecewise, LoadsLeaveAnEquationLinear) {
  for (const auto* rhs : {"step(t - 0.5) - x", "min(t, 1) - 2*x", "abs(sin(t)) + x", "sign(cos(t)) - x",
                          "mod(t, 0.3) - x", "erf(t) - floor(2*t)*3 + x"})
    EXPECT_TRUE(is_linear(scene_of_text(relaxation_file(rhs)).problem)) << rhs;
}

TEST(JumpsInTime, AreFoundWhereSignsAndStepsChange) {
  EXPECT_THAT(jumps_of("step(t - 0.25) - x", 1.0), ElementsAre(0.25));
  EXPECT_THAT(jumps_of("sign(3*t - 1) + step(t - 0.5)*sin(x)", 1.0), ElementsAre(DoubleEq(1.0 / 3.0), 0.5));
  EXPECT_THAT(jumps_of("step(max(t - 0.5, 0)) - x", 1.0), ElementsAre(DoubleEq(0.5)));
  const double third = std::numbers::pi / 3.0;
  EXPECT_THAT(jumps_of("sign(sin(3*t)) - x", 4.0),
              ElementsAre(DoubleEq(third), DoubleEq(2.0 * third), DoubleEq(3.0 * third)));
}

TEST(JumpsInTime, OfFloorsAreWhereTheirArgumentsPassWholeNumbers) {
  EXPECT_THAT(jumps_of("floor(t) - x", 3.5), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(jumps_of("floor(-2*t) - x", 1.25), ElementsAre(0.5, 1.0));
  EXPECT_THAT(jumps_of("ceil(t - 0.25)*sin(x)", 2.0), ElementsAre(0.25, 1.25));
  EXPECT_THAT(jumps_of("mod(t, 0.5) - x", 1.75), ElementsAre(0.5, 1.0, 1.5));
  EXPECT_THAT(jumps_of("floor(t^2) - x", 1.5), ElementsAre(1.0, DoubleEq(std::sqrt(2.0))));
  EXPECT_THAT(jumps_of("mod(t, 0.001) - x", 0.9995), testing::SizeIs(999));
}

// Just before a jump floor has one value and at it the next one, so that no step evaluates f on the wrong
// side.
TEST(JumpsInTime, OfFloorsAreTheFirstTimesOfTheNextValue) {
  for (const double period : {0.1, 0.3, 0.7, 1.0 / 3.0}) {
    const auto jumps = jumps_of(fmt::format("floor(t/{}) - x", period), 10.0);
    for (std::size_t k = 0; k < jumps.size(); ++k) {
      EXPECT_EQ(std::floor(jumps[k] / period), static_cast<double>(k + 1)) << period;
      EXPECT_EQ(std::floor(std::nextafter(jumps[k], 0.0) / period), static_cast<double>(k)) << period;
    }
  }
}

TEST(JumpsInTime, AreNoneWhereASignTouchesZeroOrDependsOnAnUnknown) {
  EXPECT_THAT(jumps_of("abs(t - 0.5) - x", 1.0), ElementsAre());
  EXPECT_THAT(jumps_of("step(x - t)", 1.0), ElementsAre());
  EXPECT_THAT(jumps_of("sign(exp(t)) + step(log(t + 3) - 9) - x", 1.0), ElementsAre());
}

TEST(JumpsInTime, AreThoseUpToTheEnd) {
  EXPECT_THAT(jumps_of("step(t - 3) - x", 2.0), ElementsAre());
  EXPECT_THAT(jumps_of("step(t - 3) - x", 4.0), ElementsAre(3.0));
  EXPECT_THAT(jumps_of("step(t - 3e-9) - x", 1.0), ElementsAre(3e-9));
  EXPECT_THAT(jumps_of("sign(t) + step(sin(t)) - x", 1.0), ElementsAre());
}

TEST(JumpsInTime, ThatAFileDeclaresAreTheSame) {
  const std::string file = relaxation_file("step(t - 0.5)*cos(x) - x");
  const Scene declared = scene_of_text(file + "[[jump]]\nat = 0.5\n");
  EXPECT_THAT(declared.problem.jump_times, ElementsAre(0.5));
  const double found = reference_of(scene_of_text(file)).at(1.0).value[0];
  EXPECT_EQ(found, reference_of(declared).at(1.0).value[0]);
}

// D^0.5 x = -x + mod(t, 1) with x(0) = 1: E(-t^0.5) + t^1.5 E_(0.5,2.5)(-t^0.5) - sum over n < t of
// (t - n)^0.5 E_(0.5,1.5)(-(t - n)^0.5), by mpmath in 40 digits.
TEST(Sawtooth, HasItsExactSolution) {
  Scene scene = scene_of_text(relaxation_file("-x + mod(t, 1)"));
  set_end(scene, 3.0);
  ASSERT_TRUE(scene.reference.digits);
  for (const auto& [t, x] :
       {std::pair(0.5, 0.7021154391971346441201079L), std::pair(1.0, 0.8716208329044874261038411L),
        std::pair(1.5, 0.6411799858449048263027091L), std::pair(2.75, 0.6991093459844218532493574L),
        std::pair(3.0, 0.8093775309904685309195101L)}) {
    const auto [value, bound] = scene.reference.at(t);
    EXPECT_LE(std::abs(value[0] - x), bound[0]) << t;
    EXPECT_LT(bound[0], 1e-16) << t;
  }
  EXPECT_THAT(scene.reference.digits(2.75, 24)[0].value, StartsWith("0.69910934598442185324935"));
}

// With its jumps among the grid times it has the rates of a load without jumps.
TEST(Sawtooth, LeavesSchemesTheirRates) {
  Scene scene = scene_of_text(relaxation_file("-x + mod(t, 0.5)"));
  set_end(scene, 2.0);
  const auto error = [&](const char* scheme, int steps) {
    const auto path = find_scheme(scheme)->solve(scene.problem, Grid{.end = 2.0, .steps = steps}, {});
    return std::abs(path.y(0, path.y.cols() - 1) - scene.reference.at(2.0).value[0]);
  };
  for (const auto& [scheme, rate] : {std::pair("bdf2", 2.0), std::pair("product_trapezoidal", 1.5),
                                     std::pair("l1", 1.0), std::pair("grunwald_letnikov", 1.0)}) {
    for (const int steps : {2048, 4096})
      EXPECT_NEAR(std::log2(error(scheme, steps) / error(scheme, 2 * steps)), rate, 0.07) << scheme << steps;
  }
}

// x' = 1 + floor(x), x(0) = 0: the slope is n + 1 from x = n on, so x(1 + 1/2 + 1/3) = 3.
TEST(Floor, OfAnUnknownIsASwitch) {
  const TemporaryFolder folder;
  folder.write("floor.toml",
               "end = 1.8333333333333333\n[unknown.x]\norder = 1\nrhs = \"1 + floor(x)\"\ninitial = [0]\n");
  for (const auto* scheme : {"spectral_collocation", "radau_exponentials"}) {
    const auto solved = fdebench({"solve", folder.file("floor.toml"), "--scheme", scheme, "--accuracy",
                                  "1e-8", "--at", "1.8333333333333333"});
    ASSERT_EQ(solved.code, 0) << solved.err;
    EXPECT_NEAR(std::stod(solved.out.substr(solved.out.rfind(',') + 1)), 3.0, 1e-7) << scheme;
  }
}

// D^0.5 x = 1 + step(x - 1), x(0) = 0, reaches 1 at t = pi/4, and x = 2 sqrt(t/pi) + 2 sqrt((t - pi/4)/pi)
// after that.
TEST(KnownSolutions, AreNotThoseOfASwitchThatStaysAtItsStart) {
  const std::string file = relaxation_file("1 + step(x - 1)");
  Scene scene = scene_of_text(file.substr(0, file.rfind("[1]")) + "[0]\n");
  set_end(scene, 2.0);
  const double exact = 2.0 * std::sqrt(2.0 / std::numbers::pi) +
                       2.0 * std::sqrt((2.0 - std::numbers::pi / 4.0) / std::numbers::pi);
  try {
    const reference::ReferenceValue known = reference_of(scene).at(2.0);
    EXPECT_LE(std::abs(known.value[0] - exact), known.bound[0]);
  } catch (const std::runtime_error& none) {
    EXPECT_THAT(none.what(), HasSubstr("t = "));
  }
}

// D^0.5 x = -x, x(0) = 1 is not solved by 1 - t, which the file claims.
TEST(KnownSolutions, AreNotBelievedAgainstTwoSchemes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("false.toml");
  folder.write("false.toml", relaxation_file("-x") + "[exact]\nx = \"1 - t\"\n");
  EXPECT_THAT(
      fdebench({"exact", file, "--at", "0.5,1"}),
      is_refused(3, AllOf(HasSubstr("what is known of x at t = "), HasSubstr("is not believed: it says "))));
  EXPECT_EQ(fdebench({"exact", file, "--at", "0.5,1", "--digits", "30"}).code, 3);
}

}  // namespace
}  // namespace fde::bench
