// SPDX-License-Identifier: MIT
// What equation files declare: parameters, conditions, parts that are left out, columns, factors, single
// rows.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Names = std::vector<std::string>;

const std::string decay_equation = "[unknown.x]\norder = 0.5\nrhs = \"-k*x\"\ninitial = [1]\n";

// The file with these parameters, which begin at line 3.
std::string with_parameters(const std::string& parameters) {
  return "end = 1\n[parameters]\n" + parameters + decay_equation;
}

TEST(DeclaredParameters, HaveRangesAndMeanings) {
  const auto factory =
      maker_of(with_parameters("k = { value = 1.5, above = 1, at_most = 2, meaning = \"rate\" }\n"));
  ASSERT_EQ(factory.parameters.size(), 1U);
  EXPECT_EQ(factory.parameters[0].description, "rate");
  EXPECT_EQ(factory.parameters[0].allowed(), "a number in (1, 2]");
  expect_message([&] { make_scene(factory, {{"k", 1.0}}); }, "k = 1: must be a number in (1, 2]");
}

struct WrongDeclaration {
  std::string parameters, message;
};

class DeclarationError : public testing::TestWithParam<WrongDeclaration> {};

TEST_P(DeclarationError, SaysWhereItIsAndWhatIsAllowed) {
  expect_message([] { maker_of(with_parameters(GetParam().parameters)); },
                 "test.toml: line 3, column " + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DeclarationError,
    testing::ValuesIn<WrongDeclaration>(
        {{"k = { value = 3, at_most = 2 }\n", "15: k = 3: must be a finite number of at most 2"},
         {"k = { value = 1, above = 0, at_least = 0 }\n", "40: at_least: must not be given with above"},
         {"k = { meaning = \"rate\" }\n", "1: parameter k: must have one of value, formula and choices"},
         {"k = { value = \"1\" }\n", "15: k: is a text, must be a number"},
         {"k = { choices = [\"one\"] }\n", "17: choices: must be a list of two or more words"},
         {"k = { val = 1 }\n", "7: val: no such key of parameter k, did you mean 'value'?"}}));

// df/dx of D^0.5 x = -k x.
double linear_part_of(const Problem& problem) {
  return std::get<DenseLinearPart>(problem.derivatives).matrix(0, 0);
}

TEST(DerivedParameter, IsItsFormulaUnlessItIsGiven) {
  const auto factory = maker_of(with_parameters("a = 2\nk = { formula = \"a^2\", meaning = \"rate\" }\n"));
  EXPECT_EQ(linear_part_of(make_scene(factory).problem), -4.0);
  EXPECT_EQ(linear_part_of(make_scene(factory, {{"a", 3.0}}).problem), -9.0);
  EXPECT_EQ(linear_part_of(make_scene(factory, {{"a", 3.0}, {"k", 5.0}}).problem), -5.0);
  EXPECT_EQ(factory.parameters[1].allowed(), "a finite number, or a^2");
}

TEST(DerivedParameter, DependsOnParametersAboveIt) {
  expect_message([] { scene_of_text(with_parameters("k = { formula = \"2*a\" }\na = 2\n")); },
                 "test.toml: line 3, column 20: a: no such name here");
}

TEST(Requirement, NamesTheParameterAndWhatIsAllowed) {
  const auto factory = maker_of(with_parameters("k = 1\nm = 2\n") +
                                "[[require]]\nparameter = \"k\"\nnot_negative = \"m - k\"\n"
                                "allowed = \"at most m\"\n");
  EXPECT_NO_THROW(make_scene(factory, {{"k", 2.0}}));
  expect_message([&] { make_scene(factory, {{"k", 3.0}}); }, "k = 3: must be at most m");
}

const std::string two_unknowns =
    "end = 1\n[parameters]\nim = 0\nparts = { choices = [\"together\", \"apart\"], meaning = \"columns\" }\n"
    "[unknown.y]\norder = 0.5\nrhs = \"-y - im*z\"\ninitial = [1]\n"
    "[unknown.z]\norder = 0.5\nrhs = \"im*y - z\"\ninitial = [0]\nunless = { im = 0 }\n";

TEST(Unless, LeavesOutAnUnknown) {
  const auto factory = maker_of(two_unknowns);
  EXPECT_EQ(make_scene(factory).outputs.names, Names{"y"});
  EXPECT_EQ(make_scene(factory, {{"im", 2.0}}).outputs.names, (Names{"y", "z"}));
  expect_message([] { scene_of_text(two_unknowns + "[energy]\nvalue = \"y + z\"\n"); },
                 "test.toml: line 15, column 14: z: no such name here");
}

TEST(Unless, NamesAParameterAndAValueOfIt) {
  expect_message(
      [] { maker_of(two_unknowns + "[columns]\ny = { value = \"y\", unless = { parts = \"apar\" } }\n"); },
      "test.toml: line 15, column 39: parts = apar: must be one of together, apart");
  expect_message([] { maker_of(two_unknowns + "[columns]\ny = { value = \"y\", unless = { part = 1 } }\n"); },
                 "test.toml: line 15, column 31: part: no such parameter, did you mean 'parts'?");
}

// y = E_0.5(-t^0.5) = e^t erfc(sqrt(t)).
TEST(Columns, AreFormulasWithAReference) {
  const std::string columns =
      "[columns]\nsum = { value = \"y + half\", unless = { parts = \"together\" } }\n"
      "u = \"y\"\nhalf = \"y*t/2\"\nrate = \"D(y, 0.5)\"\n";
  EXPECT_EQ(scene_of_text(two_unknowns + columns).outputs.names, (Names{"u", "half", "rate"}));
  const Scene scene = scene_of_text(two_unknowns + columns, {{"parts", "apart"}});
  ASSERT_EQ(scene.outputs.names, (Names{"sum", "u", "half", "rate"}));
  const double t = 0.25, y = std::exp(t) * std::erfc(0.5);
  const Vec exact = (Vec(4) << y + y * t / 2, y, y * t / 2, -y).finished();
  EXPECT_LT((columns_at(scene.outputs, t, Vec::Constant(1, y)) - exact).cwiseAbs().maxCoeff(), 1e-15);
  const auto known = scene.reference.at(t);
  EXPECT_LT((known.value - exact).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT(known.bound.maxCoeff(), 1e-15);
}

TEST(Columns, MustNotDependOnThemselves) {
  expect_message([] { scene_of_text(two_unknowns + "[columns]\na = \"b\"\nb = \"a + y\"\n"); },
                 "must not depend on itself");
}

// (1 + m F) x'' + F x' = rhs with F = 1/(1 + x)^2.
TEST(Factor, MultipliesAllTermsButTheFirst) {
  const auto factory = maker_of(
      "end = 1\n[parameters]\nm = 0\n[unknown.x]\nterms = [[1, 2], [0.3, 1], [\"m\", 2]]\n"
      "factor = \"1/(1 + x)^2\"\nrhs = \"-sin(x)\"\ninitial = [1, 0]\n");
  const Vec y = (Vec(2) << 0.7, -0.4).finished();
  for (const double m : {0.0, 0.6}) {
    const Scene scene = make_scene(factory, {{"m", m}});
    const double factor = 1.0 / (1.7 * 1.7), exact = (-std::sin(0.7) + factor * 0.3 * 0.4) / (1 + m * factor);
    Vec f(2);
    scene.problem.rhs(0.0, y, f);
    EXPECT_NEAR(f[1], exact, 1e-15) << m;
    const auto& own = scene.problem.equations.front();
    const double left = own.force(0.0, y) - own.factor(0.0, y) * 0.3 * -0.4;
    EXPECT_NEAR(left / own.leading.coefficient, exact, 1e-15) << m;
  }
}

TEST(SingleRow, HasAnOrderAboveOne) {
  const std::string start =
      "end = 1\n[parameters]\ng = 1.5\ns = 0\n[unknown.x]\norder = \"g\"\nchain = false\n";
  const auto factory = maker_of(start + "rhs = \"-x\"\ninitial = [1, \"s\"]\n");
  const Scene scene = make_scene(factory, {{"s", 2.0}});
  ASSERT_EQ(scene.problem.size(), 1);
  EXPECT_EQ(scene.problem.components[0].order, 1.5);
  EXPECT_EQ(scene.problem.components[0].initial, (std::vector{1.0, 2.0}));
  EXPECT_EQ(scene.smoothness.powers, (std::vector<std::vector<double>>{{1.5, 2.5, 3.0}}));
  EXPECT_EQ(make_scene(factory, {{"g", 0.5}}).problem.components[0].initial, std::vector{1.0});
  expect_message(
      [&] {
        make_scene(factory, {{"g", 0.5}, {"s", 2.0}});
      },
      "s = 2: must be 0 when g is at most 1");
}

TEST(Energy, MayContainADerivativeWhoseCoefficientIsZero) {
  const auto factory = maker_of(
      "end = 1\n[parameters]\nmu = 0.5\n[unknown.x]\nterms = [[1, 2], [\"mu\", 0.5]]\nrhs = \"-x\"\n"
      "initial = [1, 0]\n[energy]\nvalue = \"(D(x, 1)^2 + x^2)/2\"\npower = \"-mu*D(x, 1)*D(x, 0.5)\"\n");
  EXPECT_EQ(make_scene(factory, {{"mu", 0.0}}).energy.power(0.0, Vec::Ones(2)), 0.0);
  EXPECT_EQ(make_scene(factory).energy.power(0.0, Vec::Ones(3)), -0.5);
}

}  // namespace
}  // namespace fde::bench
