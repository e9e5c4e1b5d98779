// SPDX-License-Identifier: MIT
// Exact references of equation files: [exact], and linear equations.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct KnownDigits {
  std::string file, digits;  // of the first column at t = 1
};

class ExactSolution : public testing::TestWithParam<KnownDigits> {};

TEST_P(ExactSolution, HasItsDigits) {
  const auto& [file, digits] = GetParam();
  const Scene scene = scene_of_text(file);
  ASSERT_TRUE(scene.reference.digits);
  const auto value = scene.reference.digits(1.0, 30)[0].value;
  EXPECT_THAT(value, StartsWith(digits.substr(0, 28)));
  const auto known = scene.reference.at(1.0);
  EXPECT_LE(std::abs(known.value[0] - std::stod(digits)), known.bound[0] + 1e-16);
  EXPECT_LT(known.bound[0], 1e-14);
}

// mpmath, 40 digits: e erfc(1), and Gamma(1.5) + cos(1).
INSTANTIATE_TEST_SUITE_P(
    Kinds, ExactSolution,
    testing::ValuesIn<KnownDigits>(
        {{relaxation_file("-x"), "0.4275835761558070044107503444905"},
         {"end = 1\n[parameters]\nk = 0.1\n[unknown.x]\norder = 0.5\nrhs = \"-5*k*x - (1 - 5*k)*x\"\n"
          "initial = [1]\n",
          "0.4275835761558070044107503444905"},
         {relaxation_file("-x + 1 - 3*t^0.5/sqrt(9)*0"), "1.0000000000000000000000000000000"},
         {relaxation_file("-x") + "[exact]\nx = \"mittag_leffler(0.5, 1, -sqrt(t))\"\n",
          "0.4275835761558070044107503444905"},
         {relaxation_file("-x") + "[exact]\nx = \"t^1.8*gamma(1.5) + cos(t)\"\n",
          "1.426529231320897731050020349113"}}));

TEST(ExactColumns, FollowFromSumsOfPowers) {
  // x = 1 + 2 t + t^2.5: D^0.5 x = 2 t^0.5 / Gamma(1.5) + Gamma(3.5) / 2 t^2, x' = 2 + 2.5 t^1.5.
  const Scene scene = scene_of_text(
      "end = 2\n[unknown.x]\nterms = [[1, 1.5], [1, 0.5]]\nrhs = \"x\"\ninitial = [1, 2]\n"
      "[exact]\nx = \"1 + 2*t + t^2.5\"\n");
  const double t = 0.7;
  const auto known = scene.reference.at(t);
  EXPECT_NEAR(known.value[0], 1.0 + 2.0 * t + std::pow(t, 2.5), 1e-15);
  EXPECT_NEAR(known.value[1], 2.0 * std::sqrt(t) / std::tgamma(1.5) + std::tgamma(3.5) / 2.0 * t * t, 1e-15);
  EXPECT_NEAR(known.value[2], 2.0 + 2.5 * std::pow(t, 1.5), 1e-15);
}

TEST(ExactColumns, AreAskedForWhereTheyDoNotFollow) {
  const std::string file =
      "end = 2\n[unknown.x]\nterms = [[1, 1.5], [1, 0.5]]\nrhs = \"x\"\ninitial = [1, 2]\n[exact]\n"
      "x = \"1 + 2*sin(t)\"\n";
  expect_message([&] { scene_of_text(file); },
                 "test.toml: line 7, column 1: exact: has no \"D(x,0.5)\", it must have this column too");
  const Scene scene = scene_of_text(file + "\"D(x, 0.5)\" = \"t\"\n");
  EXPECT_NEAR(scene.reference.at(0.5).value[2], 2.0 * std::cos(0.5), 1e-15);  // x'
  expect_message(
      [] {
        scene_of_text(
            "end = 1\n[unknown.x]\norder = 1\nrhs = \"y\"\ninitial = [1]\n[unknown.y]\n"
            "order = 1\nrhs = \"x\"\ninitial = [1]\n[exact]\nx = \"t\"\n");
      },
      "test.toml: line 11, column 1: exact: has no y, it must have every unknown");
}

// D^0.6 x = -x + y, D^1.5 y = -x - 4 y: the scene linear_system.
TEST(LinearEquationFile, MayHaveSeveralUnknowns) {
  const Scene file = scene_of_text(
      "end = 5\n[unknown.x]\norder = 0.6\nrhs = \"y - x\"\ninitial = [1]\n"
      "[unknown.y]\norder = 1.5\nrhs = \"-x - 4*y\"\ninitial = [0.5, 0]\n");
  const Scene code = scene_of("linear_system");
  for (const double t : {0.5, 5.0}) {
    const auto ours = file.reference.digits(t, 25), theirs = code.reference.digits(t, 25);
    EXPECT_EQ(ours[0].value, theirs[0].value);
    EXPECT_EQ(ours[1].value, theirs[1].value);
  }
}

// sqrt(2) is no fraction: the solution is available in double only.
TEST(LinearEquationFile, HasNoDigitsOfCoefficientsThatAreNoFractions) {
  const Scene scene = scene_of_text(relaxation_file("-x*sqrt(2)"));
  EXPECT_TRUE(scene.reference.at);
  EXPECT_FALSE(scene.reference.digits);
  const auto [value, bound] = scene.reference.at(1.0);
  EXPECT_LE(std::abs(value[0] - 0.336204002446341212854298228058L), bound[0]);  // e^2 erfc(sqrt(2))
  EXPECT_LT(bound[0], 1e-16);
}

// Orders, coefficients of terms and of rows, and initial values that are fractions but no decimals. By
// mpmath, on Talbot's contour in 45 digits.
TEST(LinearEquationFile, TakesFractionsAsTheyAreWritten) {
  const Scene scene = scene_of_text(
      "end = 1\n[unknown.x]\nterms = [[\"1/3\", 0.5]]\nrhs = \"y/3 - x/7\"\ninitial = [\"1/7\"]\n"
      "[unknown.y]\norder = \"1/3\"\nrhs = \"-2*x/3 - y/9\"\ninitial = [\"-2/3\"]\n");
  ASSERT_TRUE(scene.reference.digits);
  EXPECT_THAT(scene.reference.digits(1.0, 30)[0].value, StartsWith("-0.285680088805702827565494222"));
  const auto [value, bound] = scene.reference.at(1.0);
  EXPECT_LE(std::abs(value[0] + 0.285680088805702827565494222283L), bound[0]);
}

// With a constraint of order above 1: a literal, and one whose D^alpha q starts at another value than 0.
TEST(LinearMechanicsFile, HasAllDigitsAboveOrderOne) {
  const Scene literal = scene_of_text(
      "end = 0.6\n[coordinate.x]\ninitial = [0.3, 0.5]\n[coordinate.y]\ninitial = [-0.2, 0.2]\n[mechanics]\n"
      "lagrangian = \"(D(x,1)^2 + D(y,1)^2)/2 - x^2 - y^2/2\"\n"
      "constraints = [\"D(x,1) + 0.5*D(y,1) + 0.3*D(x,1.6) - 0.9*D(y,1.6) - 0.6\"]\n");
  EXPECT_THAT(literal.reference.digits(0.6, 30)[0].value, StartsWith("-3180221.20305596913115747188668"));
  const Scene moving = scene_of_text(
      "end = 0.6\n[coordinate.x]\ninitial = [0.3, 0.5]\n[coordinate.y]\ninitial = [-0.2, 0.2]\n[mechanics]\n"
      "lagrangian = \"(D(x,1)^2 + 3*D(y,1)^2)/2 - x^2 - y^2/2 + 0.1*y\"\n"
      "constraints = [\"D(x,1) + 0.7*D(y,1) + 0.3*D(x,1.4) + 0.9*D(y,1.4) - 0.37\"]\n");
  EXPECT_THAT(moving.reference.digits(0.6, 30)[0].value, StartsWith("0.46302989874722495558259238"));
  const auto [value, bound] = moving.reference.at(0.6);
  EXPECT_LE(std::abs(value[0] - 0.463029898747224955582592387317L), bound[0]);
  EXPECT_LT(bound[0], 1e-15);
}

// Loads that start later: any number of samples, ramps, parabolas. By Mittag-Leffler functions of mpmath, and
// on Talbot's contour.
TEST(LinearEquationFile, MayHaveManyLoadsAndRamps) {
  std::string load = "0";
  for (int k = 0; k < 200; ++k)
    load += fmt::format(" + {}*(step(t - {}/100) - step(t - {}/100))", k % 7, k, k + 1);
  const Scene many = scene_of_text(relaxation_file(load + " - x"));
  ASSERT_TRUE(many.reference.at);
  double sum = std::exp(1.0) * std::erfc(1.0);
  const auto response = [](double t) { return 1.0 - std::exp(t) * std::erfc(std::sqrt(t)); };
  for (int k = 0; k < 100; ++k) sum += k % 7 * (response(1.0 - k / 100.0) - response(1.0 - (k + 1) / 100.0));
  EXPECT_NEAR(many.reference.at(1.0).value[0], sum, 1e-12);
  const std::string ramps =
      "end = 9\n[unknown.x]\norder = 0.5\nrhs = \"(t - 3)*step(t - 3) - x\"\ninitial = [0]\n"
      "[unknown.y]\norder = 0.5\nrhs = \"t^2*step(t - 3.5)*step(t - 1) - y\"\ninitial = [0]\n";
  const Scene ramp = scene_of_text(ramps);
  ASSERT_TRUE(ramp.reference.at);
  EXPECT_NEAR(ramp.reference.at(5.0).value[0], 1.0680268759479280753859175322, 1e-15);
  EXPECT_EQ(ramp.reference.at(3.0).value[0], 0.0);
}

// E_0.5(-15/13) in 40 digits.
TEST(LinearEquationFile, DividesExactly) {
  const auto [value, bound] = scene_of_text(relaxation_file("-x*5/13")).reference.at(9.0);
  EXPECT_LE(std::abs(value[0] - 0.388935931039400981214484822939L), bound[0]);
  EXPECT_LT(bound[0], 1e-16);
}

// The multiplier starts like t^-0.3. Its noise on the first panels, which D(x,1.8) takes up, is no error
// later.
TEST(ComputedReference, HasABoundOfTheSizeOfItsErrorUnderAForceAboveOrderOne) {
  const Scene scene = scene_of_text(
      "end = 1\n[coordinate.x]\ninitial = [0.5, 0.3]\n[coordinate.y]\ninitial = [0.2, -0.5]\n[mechanics]\n"
      "lagrangian = \"(D(x,1)^2 + D(y,1)^2)/2 - (x^2 + 2*y^2 + x^2*y^2)/2\"\n"
      "forces = { x = \"-0.4*D(x,1.8)\", y = \"-0.3*D(y,0.5)\" }\n"
      "constraints = [\"D(x,1) + 0.6*D(y,1) + 0.5*D(y,0.3)\"]\n");
  EXPECT_LT(reference_of(scene).at(1.0).bound.maxCoeff(), 1e-11);
}

// Own collocation of two resolutions.
TEST(ComputedReference, MayHaveALoadThatIsInfiniteAtTheStart) {
  const Scene scene =
      scene_of_text("end = 3.7\n[unknown.x]\norder = 0.7\nrhs = \"t^(-0.2) - sin(x)\"\ninitial = [0.2]\n");
  const auto [value, bound] = reference_of(scene).at(3.7);
  EXPECT_NEAR(value[0], 0.7893871229988, 1e-12);
  EXPECT_LT(bound[0], 1e-12);
}

TEST(NonlinearEquationFile, DeclaresNoReference) {
  EXPECT_FALSE(scene_of_text(relaxation_file("-x^2")).reference.at);
  EXPECT_FALSE(scene_of_text(relaxation_file("-x + cos(t)")).reference.at);
}

// D^0.6 y = (t < 1): t^0.6 / Gamma(1.6) minus the same with t - 1. The reference is from two methods, because
// sign is not a load of the linear reference.
TEST(ComputedReference, KnowsDeclaredJumps) {
  const Scene scene = scene_of_text(
      "end = 2\n[unknown.y]\norder = 0.6\nrhs = \"(1 - sign(t - 1))/2\"\ninitial = [0]\n[[jump]]\nat = "
      "1\n");
  ASSERT_FALSE(scene.reference.at);
  const reference::Reference reference = reference_of(scene);
  for (const double t : {0.5, 1.5, 2.0}) {
    const double since = std::max(0.0, t - 1.0);
    const auto [value, bound] = reference.at(t);
    EXPECT_NEAR(value[0], (std::pow(t, 0.6) - std::pow(since, 0.6)) / std::tgamma(1.6), bound[0]) << t;
    EXPECT_LT(bound[0], 1e-13);
  }
}

}  // namespace
}  // namespace fde::bench
