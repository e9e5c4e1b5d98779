// SPDX-License-Identifier: MIT
// Formulas: their values, and their errors with positions.

#include "fdebench/benchmarks/expressions/formula.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench {
namespace {

// The value at t = 0.7, x = 0.3, y = -1.2.
double value_of(const std::string& text) {
  ExpressionPool pool(NumberStorage::values);
  const auto formula = read_formula(text, names_of_t_x_y(pool), pool);
  return Program(pool, {formula}, 2)(0.7, (Vec(2) << 0.3, -1.2).finished());
}

struct KnownValue {
  std::string text;
  double value;
};

class Formula : public testing::TestWithParam<KnownValue> {};

TEST_P(Formula, HasItsValue) {
  const auto& [text, value] = GetParam();
  EXPECT_NEAR(value_of(text), value, 4e-16 * std::max(1.0, std::abs(value))) << text;
}

// mpmath, 30 digits.
INSTANTIATE_TEST_SUITE_P(
    Values, Formula,
    testing::Values(
        KnownValue{"1 + 2*3", 7.0}, KnownValue{"(1 + 2)*3", 9.0}, KnownValue{"2^3^2", 512.0},
        KnownValue{"-2^2", -4.0}, KnownValue{"2^-1", 0.5}, KnownValue{"8/4/2", 1.0},
        KnownValue{"1 - 2 - 3", -4.0}, KnownValue{"- - 3", 3.0}, KnownValue{"1e-3", 0.001},
        KnownValue{".5", 0.5}, KnownValue{"2.", 2.0}, KnownValue{"x^3", 0.027}, KnownValue{"x^0", 1.0},
        KnownValue{"x^-2", 11.111111111111111}, KnownValue{"x^0.5", 0.54772255750516611},
        KnownValue{"x^y", 4.2408654551313070}, KnownValue{"sin(x)", 0.29552020666133958},
        KnownValue{"cos(x)", 0.95533648912560602}, KnownValue{"tan(x)", 0.30933624960962326},
        KnownValue{"asin(x)", 0.30469265401539751}, KnownValue{"acos(x)", 1.2661036727794991},
        KnownValue{"atan(x)", 0.29145679447786709}, KnownValue{"atan2(x, y)", 2.8966139904629289},
        KnownValue{"sinh(x)", 0.30452029344714261}, KnownValue{"cosh(x)", 1.0453385141288605},
        KnownValue{"tanh(x)", 0.29131261245159090}, KnownValue{"exp(y)", 0.30119421191220209},
        KnownValue{"log(x)", -1.2039728043259359}, KnownValue{"sqrt(t)", 0.83666002653407555},
        KnownValue{"abs(y)", 1.2}, KnownValue{"sign(y)", -1.0}, KnownValue{"step(y)", 0.0},
        KnownValue{"step(x - x)", 0.5}, KnownValue{"min(x, y)", -1.2}, KnownValue{"max(x, y)", 0.3},
        KnownValue{"pi", 3.1415926535897932}, KnownValue{"gamma(2.5)", 1.3293403881791370},
        KnownValue{"floor(y)", -2.0}, KnownValue{"ceil(y)", -1.0}, KnownValue{"floor(x - x)", 0.0},
        KnownValue{"ceil(t)", 1.0}, KnownValue{"floor(3)", 3.0}, KnownValue{"ceil(3)", 3.0},
        KnownValue{"mod(t, x)", 0.1}, KnownValue{"mod(y, 1)", 0.8}, KnownValue{"mod(t, y)", -0.5},
        KnownValue{"mod(-3, 2)", 1.0}, KnownValue{"mod(3, -2)", -1.0},
        KnownValue{"erf(x)", 0.32862675945912743}, KnownValue{"erf(y)", -0.91031397822963538},
        KnownValue{"erfc(x)", 0.67137324054087257}, KnownValue{"erfc(y)", 1.9103139782296354},
        // E_0.5(-1) = e erfc(1)
        KnownValue{"mittag_leffler(0.5, 1, -1)", 0.42758357615580701}, KnownValue{" x *\ty\n", -0.36}));

// mpmath, 25 digits: 1 - erf(x) would have none of them beyond x = 6.
TEST(ErfcInFormulas, KeepsItsDigitsWhereItIsSmall) {
  for (const auto& [text, value] : {KnownValue{"erfc(5)", 1.537459794428034850188e-12},
                                    KnownValue{"erfc(10)", 2.088487583762544757001e-45},
                                    KnownValue{"erfc(20)", 5.395865611607900928935e-176},
                                    KnownValue{"erfc(26)", 5.663192408856142846476e-296}})
    EXPECT_NEAR(value_of(text) / value, 1.0, 1e-15) << text;
}

class Derivative : public testing::TestWithParam<std::string> {};

TEST_P(Derivative, IsThatOfTheDifferences) {
  ExpressionPool pool(NumberStorage::values);
  const auto formula = read_formula(GetParam(), names_of_t_x_y(pool), pool);
  const Vec y = (Vec(2) << 0.3, -1.2).finished();
  for (int variable = 1; variable <= 2; ++variable) {
    const double h = 0x1p-17;
    Vec above = y, below = y;
    above[variable - 1] += h;
    below[variable - 1] -= h;
    const Program program(pool, {formula}, 2);
    const double difference = (program(0.7, above) - program(0.7, below)) / (2.0 * h);
    const auto exact = Program(pool, {pool.derivative(formula, variable)}, 2)(0.7, y);
    EXPECT_NEAR(exact, difference, 2e-9 * std::max(1.0, std::abs(difference)))
        << GetParam() << " " << variable;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEveryOperation, Derivative,
                         testing::Values("x + y*x - y/x", "x^3*y^2", "x^y", "2^x", "x^0.7", "x^-2", "-x*-y",
                                         "sin(x*y)", "cos(x*y)", "tan(x*y)", "asin(x*y)", "acos(x*y)",
                                         "atan(x*y)", "atan2(x*y, y + x)", "sinh(x*y)", "cosh(x*y)",
                                         "tanh(x*y)", "exp(x*y)", "log(x*x + y*y)", "sqrt(x*x + y*y)",
                                         "abs(x*y)", "sign(x)*x", "step(x)*y", "min(x, y)*x", "max(x, y)*y",
                                         "mittag_leffler(0.7, 1.3, x*y)", "erf(x*y)", "erfc(x - y)",
                                         "floor(y)*x", "ceil(y)*x", "mod(x*y, 1)", "mod(x, y)"));

TEST(ExpressionPool, AreMadeOnce) {
  ExpressionPool pool(NumberStorage::values);
  const auto names = names_of_t_x_y(pool);
  EXPECT_EQ(read_formula("sin(x)*y", names, pool), read_formula("(sin( x ))*y", names, pool));
}

// What adds the parts of an expression reads it meanwhile.
TEST(ExpressionPool, AreNotMovedByOthers) {
  ExpressionPool pool(NumberStorage::values);
  const auto first = pool.number(1);
  const auto* before = &pool[first];
  for (int other = 2; other < 5000; ++other) pool.number(other);
  EXPECT_EQ(&pool[first], before);
}

// (((x + x)^2)^2)^2 ...: expanded, it would have 2^(2^60) as its coefficient.
TEST(ExpressionPool, ArePowersNotMultipliedOut) {
  std::string text = "x + x";
  for (int i = 0; i < 60; ++i) text = fmt::format("({})^2", text);
  EXPECT_EQ(value_of(text), 0.0);
  EXPECT_TRUE(std::isinf(value_of("9^9^9^9")));
}

struct Fault {
  std::string text, what;
  std::size_t place;
};

class FormulaFaults : public testing::TestWithParam<Fault> {};

TEST_P(FormulaFaults, SayWhatAndWhere) {
  const auto& [text, what, place] = GetParam();
  ExpressionPool pool(NumberStorage::values);
  try {
    read_formula(text, names_of_t_x_y(pool), pool);
    FAIL() << text;
  } catch (const FormulaError& fault) {
    EXPECT_EQ(std::string(fault.what()).find(what), 0U) << fault.what();
    EXPECT_EQ(fault.byte_offset, place) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, FormulaFaults,
    testing::Values(Fault{"", "the formula ends, there must be a number, a name or '('", 0},
                    Fault{"1 +", "the formula ends, there must be a number, a name or '('", 3},
                    Fault{"2 x", "'x': must be an operation or the end", 2},
                    Fault{"1 + * 2", "'*': must be a number, a name or '('", 4},
                    Fault{"(x", "the formula ends, there must be an operation or ')'", 2},
                    Fault{"x)", "')': must be an operation or the end", 1},
                    Fault{"x ** 2", "'**': must be '^' for a power", 3},
                    Fault{"1 + zeta", "zeta: no such name here", 4},
                    Fault{"e^x", "e: no such name here; e^x is exp(x)", 0},
                    Fault{"__proto__", "'_': must be a number, a name or '('", 0},
                    Fault{"sin x", "'x': must be '(', sin being a function", 4},
                    Fault{"atan2(x)", "')': must be ',', atan2 taking 2 arguments", 7},
                    Fault{"sin(x, y)", "',': must be ')', sin taking 1 argument", 5},
                    Fault{"1 + 1e400", "1e400: overflows double", 4},
                    Fault{"D(x, 0.5)", "D: a derivative is not allowed here", 0},
                    Fault{"x \xc3\xa4", "'\xc3\xa4': must be an operation or the end", 2}));

TEST(FormulaFaults, OfDeepBracketsEndsAtOnce) {
  for (const std::string& text :
       {std::string(9'000, '('), std::string(19'000, '-'), std::string(100'000, '(')}) {
    ExpressionPool pool(NumberStorage::values);
    EXPECT_THROW(read_formula(text, names_of_t_x_y(pool), pool), FormulaError);
  }
  std::string powers = "x";
  for (int i = 0; i < 5'000; ++i) powers += "^x";
  ExpressionPool pool(NumberStorage::values);
  EXPECT_THROW(read_formula(powers, names_of_t_x_y(pool), pool), FormulaError);
}

}  // namespace
}  // namespace fde::bench
