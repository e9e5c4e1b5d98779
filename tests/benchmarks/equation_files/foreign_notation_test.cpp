// SPDX-License-Identifier: MIT
// What messages say of names and symbols of other languages: the formulas that they give have the values of
// the functions that they replace.

#include "fdebench/benchmarks/expressions/foreign_notation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// The formula behind "it is", in x and y.
double value_of_hint(const std::string& name, double x, double y) {
  const std::string hint = function_hint(name), before = "it is ";
  auto formula = hint.substr(hint.find(before) + before.size());
  formula = formula.substr(0, formula.find(" for "));
  ExpressionPool pool(NumberStorage::values);
  const FormulaNames names{.resolve = [&](std::string_view one) -> std::optional<Expression> {
    if (one == "x") return pool.number(fmt::format("{}", x));
    if (one == "y") return pool.number(fmt::format("{}", y));
    return std::nullopt;
  }};
  return Program(pool, {read_formula(formula, names, pool)}, 0)(0.0, Vec());
}

struct ReplacedFunction {
  std::string name;
  double (*function)(double x, double y);
  std::vector<double> places;
};

class ForeignFunction : public testing::TestWithParam<ReplacedFunction> {};

TEST_P(ForeignFunction, HasTheValueOfItsReplacement) {
  const auto& [name, function, places] = GetParam();
  for (const double x : places) {
    const double exact = function(x, 0.75);
    EXPECT_NEAR(value_of_hint(name, x, 0.75), exact, 4e-15 * std::max(1.0, std::abs(exact)))
        << name << " " << x;
  }
}

const std::vector<double> anywhere{-1.75, -0.3, 0.4, 2.5};

INSTANTIATE_TEST_SUITE_P(
    Values, ForeignFunction,
    testing::Values(
        ReplacedFunction{"log10", [](double x, double) { return std::log10(x); }, {0.02, 7.0}},
        ReplacedFunction{"log2", [](double x, double) { return std::log2(x); }, {0.02, 7.0}},
        ReplacedFunction{"log1p", [](double x, double) { return std::log1p(x); }, {-0.5, 7.0}},
        ReplacedFunction{"expm1", [](double x, double) { return std::expm1(x); }, anywhere},
        ReplacedFunction{"pow", [](double x, double y) { return std::pow(x, y); }, {0.3, 4.0}},
        ReplacedFunction{"hypot", [](double x, double y) { return std::hypot(x, y); }, anywhere},
        ReplacedFunction{"asinh", [](double x, double) { return std::asinh(x); }, anywhere},
        ReplacedFunction{"acosh", [](double x, double) { return std::acosh(x); }, {1.25, 3.0}},
        ReplacedFunction{"atanh", [](double x, double) { return std::atanh(x); }, {-0.5, 0.75}},
        ReplacedFunction{"cot", [](double x, double) { return std::cos(x) / std::sin(x); }, anywhere},
        ReplacedFunction{"coth", [](double x, double) { return std::cosh(x) / std::sinh(x); }, anywhere},
        ReplacedFunction{"trunc", [](double x, double) { return std::trunc(x); }, anywhere},
        ReplacedFunction{"round", [](double x, double) { return std::round(x); }, {0.25, 1.25, 2.5, -1.25}},
        ReplacedFunction{"fmod", [](double x, double y) { return std::fmod(x, y); }, anywhere},
        ReplacedFunction{"lgamma", [](double x, double) { return std::lgamma(x); }, {0.25, 4.5}},
        ReplacedFunction{"sgn", [](double x, double) { return x < 0.0 ? -1.0 : 1.0; }, anywhere},
        ReplacedFunction{"Heaviside", [](double x, double) { return x < 0.0 ? 0.0 : 1.0; }, anywhere}),
    [](const auto& one) { return one.param.name; });

// The message for a formula in t, x and y.
std::string complaint_about(const std::string& text) {
  ExpressionPool pool(NumberStorage::values);
  auto names = names_of_t_x_y(pool);
  names.derivative = [&](std::string_view, Expression, bool) { return pool.variable(1); };
  return message_of<FormulaError>([&] { read_formula(text, names, pool); });
}

struct ForeignFormula {
  std::string text, hint;
};

class ForeignNotation : public testing::TestWithParam<ForeignFormula> {};

TEST_P(ForeignNotation, IsSaidHowToWriteHere) {
  const auto& [text, hint] = GetParam();
  EXPECT_THAT(complaint_about(text), HasSubstr(hint)) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Formulas, ForeignNotation,
    testing::Values(ForeignFormula{"ln(x)", "ln: no such function here; here it is log(x)"},
                    ForeignFormula{"np.sin(t)", "names have no prefix"},
                    ForeignFormula{"PI*x", "here it is pi"}, ForeignFormula{"Sin(t)", "did you mean 'sin'?"},
                    ForeignFormula{"x.^2", "without a point"}, ForeignFormula{"t > 1", "step(a - b)"},
                    ForeignFormula{"x == 1", "step(a - b)"}, ForeignFormula{"x = 1", "is the formula a - b"},
                    ForeignFormula{"vx^2", "the derivative of x is"}, ForeignFormula{"x && y", "step(a - b)"},
                    ForeignFormula{"if(t, 1, 0)", "step(a - b)"}, ForeignFormula{"2x", "needs its '*'"},
                    ForeignFormula{"2(x + y)", "needs its '*'"}, ForeignFormula{"x(t)", "x(t) is x"},
                    ForeignFormula{"delay(x, 4)", "x(t - tau)"}, ForeignFormula{"x'", "is D(x, q)"},
                    ForeignFormula{"dx + y", "the derivative of x is D(x, 1)"},
                    ForeignFormula{"xdot", "the derivative of x is D(x, 1)"},
                    ForeignFormula{"1,5*x", "as 1.5"}, ForeignFormula{"1d-3", "follows e"},
                    ForeignFormula{"|x|", "|x| is abs(x)"}, ForeignFormula{"3!", "gamma(n + 1)"},
                    ForeignFormula{"2i*x", "two unknowns"}, ForeignFormula{"x \u2212 y", "here it is -"},
                    ForeignFormula{"2\u00b7x", "here it is *"},
                    ForeignFormula{"max(x, y, 1)", "max(a, max(b, c))"},
                    ForeignFormula{"interp1(t)", "a function of samples is a [table.u]"}));

// A name at a distance is no slip of the pen.
TEST(ForeignNotation, IsNotTakenForAnotherNameThatLooksAlike) {
  for (const std::string text : {"zeta*x", "besselj(0, t)", "k*x", "lambda", "sin x"})
    EXPECT_THAT(complaint_about(text), Not(HasSubstr("did you mean"))) << text;
}

}  // namespace
}  // namespace fde::bench
