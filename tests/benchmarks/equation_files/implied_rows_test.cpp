// SPDX-License-Identifier: MIT
// Fractional integrals J(f, q) and derivatives D(g, q) of formulas of t in right-hand sides.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/equation_files/file_commands.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string file_with(const std::string& order, const std::string& rhs, const std::string& initial) {
  return "end = 2\n[unknown.x]\norder = " + order + "\nrhs = \"" + rhs + "\"\ninitial = [" + initial + "]\n";
}

// x(t) by the reference and its bound.
std::pair<double, double> referenced(const std::string& text, const std::string& t) {
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  const auto answer = fdebench({"exact", folder.file("f.toml"), "--at", t});
  EXPECT_EQ(answer.err, "");
  EXPECT_THAT(answer.out, StartsWith("t,x,bound\n"));  // the rows are no columns
  const auto line = answer.out.substr(answer.out.find('\n') + 1);
  const auto first = line.find(',') + 1, second = line.find(',', first) + 1;
  return {std::stod(line.substr(first)), std::stod(line.substr(second))};
}

double solved_by(const std::string& text, const std::string& t, const std::vector<std::string>& how) {
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  std::vector<std::string> words{"solve", folder.file("f.toml"), "--at", t, "--scheme"};
  words.insert(words.end(), how.begin(), how.end());
  const auto answer = fdebench(words);
  EXPECT_EQ(answer.err, "");
  return std::stod(answer.out.substr(answer.out.rfind(',') + 1));
}

struct SolvedFile {
  std::string text, t;
  double value;
};

const std::vector<SolvedFile> solved_files{
    // Abel's equation of the second kind x = 1 - J^1/2 x: x = E_1/2(-t^1/2) = e^t erfc(t^1/2).
    {file_with("0", "1 - J(x, 0.5) - x", "1"), "1", std::exp(1.0) * std::erfc(1.0)},
    // x' = -x + J^1/2 x, x(0) = 1, has the transform 1/(s + 1 - s^-1/2), inverted by mpmath.
    {file_with("1", "J(x, 1/2) - x", "1"), "2", 1.07135293236281769969},
    // x' = D^0.4 sin(3t): x = J^0.6 sin(3t) = 3 t^1.6 E_2,2.6(-9 t^2), by mpmath.
    {file_with("1", "D(sin(3*t), 0.4)", "0"), "1", 0.67200948165877728324},
    // D^0.3 x = D^0.7 t^2: x = 2 t^1.6/Gamma(2.6).
    {file_with("0.3", "D(t^2, 0.7)", "0"), "1", 2.0 / std::tgamma(2.6)},
    // Whole orders: x' = (t^3)'' = 6 t.
    {file_with("1", "D(t^3, 2)", "0"), "2", 12.0},
    // The integral of an integral: J^0.3 J^0.9 1 = t^1.2/Gamma(2.2), and of it once more.
    {file_with("1", "J(J(1, 0.9), 0.3)", "0"), "2", std::pow(2.0, 2.2) / std::tgamma(3.2)},
    // An integral of an order above 1: x' = J^1.5 t, x = t^3.5/Gamma(4.5).
    {file_with("1", "J(t, 1.5)", "0"), "2", std::pow(2.0, 3.5) / std::tgamma(4.5)},
};

TEST(ImpliedRows, HaveTheirSolutionAsReference) {
  for (const auto& [text, t, value] : solved_files) {
    const auto [found, bound] = referenced(text, t);
    EXPECT_NEAR(found, value, bound + 1e-13) << text;
    EXPECT_LT(bound, 1e-11) << text;
  }
}

TEST(ImpliedRows, AreSolvedBySchemes) {
  for (const auto& [text, t, value] : solved_files) {
    EXPECT_NEAR(solved_by(text, t, {"spectral_collocation", "--accuracy", "1e-10"}), value, 1e-8) << text;
    EXPECT_NEAR(solved_by(text, t, {"product_trapezoidal", "--steps", "1024"}), value, 2e-3) << text;
  }
}

// x = t^2: x' = 2t - J^1/2(x y) + J^1/2(t^3) with y = t, an integral of a product of unknowns.
TEST(ImpliedRows, TakeNonlinearIntegrands) {
  const std::string text =
      "end = 1\n[unknown.y]\norder = 1\nrhs = \"1\"\ninitial = [0]\n"
      "[unknown.x]\norder = 1\nrhs = \"2*t - J(x*y, 0.5) + J(t^3, 0.5)\"\ninitial = [0]\n";
  EXPECT_NEAR(solved_by(text, "1", {"spectral_collocation", "--accuracy", "1e-10"}), 1.0, 1e-8);
}

// x' + x = int_0^t e^(s-t) x ds, x = e^-t cosh t, from [exact]: of it x' and 2x follow, a column with the
// integral does not.
TEST(ImpliedRows, LeaveTheExactSolutionToTheUnknowns) {
  const auto exact = [](const std::string& columns) {
    const TemporaryFolder folder;
    folder.write("f.toml", file_with("1", "exp(-t)*J(exp(t)*x, 1) - x", "1") +
                               "[exact]\nx = \"exp(-t)*cosh(t)\"\n" + columns);
    return fdebench({"exact", folder.file("f.toml"), "--at", "1"});
  };
  const auto value = [&exact](const std::string& columns) {
    const auto out = exact(columns).out;
    return std::stod(out.substr(out.find("\n1,") + 3));
  };
  const double x = std::exp(-1.0) * std::cosh(1.0);
  EXPECT_NEAR(value(""), x, 1e-15);
  EXPECT_NEAR(value("[columns]\ndx = \"D(x, 1)\"\n"), -std::exp(-2.0), 1e-15);
  EXPECT_NEAR(value("[columns]\ntwice = \"2*x\"\n"), 2.0 * x, 1e-15);
  const auto refused = exact("[columns]\nsum = \"x + D(x, 1)\"\n");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("line 7, column 1: exact: does not determine the column sum"));
}

// J(t - 1) is its value at t - 1, here 0: J' = D^0.4 sin(3t).
TEST(ImpliedRows, LeaveAnUnknownOfTheSameNameAlone) {
  const std::string text =
      "end = 1\n[unknown.J]\norder = 1\nrhs = \"D(sin(3*t), 0.4) + J(t - 1)\"\ninitial = [0]\nbefore = "
      "\"0\"\n";
  EXPECT_NEAR(solved_by(text, "1", {"spectral_collocation", "--accuracy", "1e-10"}), 0.67200948165877728324,
              1e-8);
}

// A warning is about the row that is off most, which is no column here.
TEST(ImpliedRows, AreNamedInWarnings) {
  const auto warning = [](const std::string& text) {
    return command(text, {"solve", "--scheme", "product_trapezoidal", "--steps", "20"}).err;
  };
  EXPECT_THAT(warning("end = 5\n[unknown.x]\norder = 0.7\nrhs = \"cos(40*t) - J(cos(30*t), 1.5) - x\"\n"
                      "initial = [1]\n"),
              HasSubstr("; J(cos(30*t), 1.5) at t = 5 is "));
  EXPECT_THAT(warning("end = 20\n[unknown.y]\ntransfer = \"(1 + s^0.3)/(s^1.9 + 0.01*s^0.5 + 9)\"\n"
                      "input = \"1 - 300*y\"\n"),
              HasSubstr("; the state of y at t = 15 is "));
}

TEST(ImpliedRows, AreRefusedAtTheirPlace) {
  const auto refusal = [](const std::string& rhs) {
    const TemporaryFolder folder;
    folder.write("f.toml", file_with("1", rhs, "1"));
    const auto answer = fdebench({"solve", folder.file("f.toml"), "--scheme", "l1", "--steps", "4"});
    EXPECT_EQ(answer.code, 2);
    return answer.err.substr(answer.err.find("line"));
  };
  EXPECT_THAT(refusal("1 - J(x, 0)"),
              StartsWith("line 4, column 17: order of J = 0: must be a number in (0, 10]"));
  EXPECT_THAT(refusal("1 + J(2*y, 0.5)"), StartsWith("line 4, column 16: y: no such name here"));
  EXPECT_THAT(refusal("1 + J(x)"),
              AllOf(StartsWith("line 4, column 12: J: no such function here"), HasSubstr("J(f, q)")));
  EXPECT_THAT(refusal("D(x^2, 0.5)"),
              StartsWith("line 4, column 8: D of a formula: must be of t and the parameters"));
  EXPECT_THAT(refusal("x + D(step(t - 1), 0.5)"), HasSubstr("must not contain the sign, step or floor of t"));
  EXPECT_THAT(refusal("x + D(abs(t - 1), 1.5)"), HasSubstr("must not contain abs, min or max of t"));
  EXPECT_THAT(refusal("D(t^2, x)"), StartsWith("line 4, column 15: x: no such name here"));
}

}  // namespace
}  // namespace fde::bench
