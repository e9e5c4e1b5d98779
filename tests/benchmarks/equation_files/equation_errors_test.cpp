// SPDX-License-Identifier: MIT
// Invalid equation files: one line with file, line and column.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct InvalidFile {
  std::string text;
  int line, column;
  std::string what;
};

class WrongEquationFile : public testing::TestWithParam<InvalidFile> {};

TEST_P(WrongEquationFile, IsRefusedInOneLine) {
  const auto& [text, line, column, what] = GetParam();
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  const std::string file = folder.file("f.toml");
  EXPECT_THAT(
      fdebench({"solve", file, "--scheme", "l1", "--steps", "4"}),
      is_refused(2, AllOf(StartsWith(fmt::format("fdebench: {}: line {}, column {}: ", file, line, column)),
                          HasSubstr(what))));
}

const std::string x = "[unknown.x]\norder = 0.5\nrhs = \"-x\"\ninitial = [1]\n";

std::string with(const std::string& lines) { return "end = 1\n" + lines; }
// A file with one unknown x, from its order, rhs and initial lines.
std::string unknown(const std::string& order, const std::string& rhs, const std::string& initial) {
  return with("[unknown.x]\n" + order + "\nrhs = " + rhs + "\ninitial = " + initial + "\n");
}

// One with this right-hand side.
std::string with_rhs(const std::string& rhs) { return unknown("order = 0.5", rhs, "[1]"); }

// x within `depth` pairs of brackets.
std::string brackets(std::size_t depth) { return std::string(depth, '(') + "x" + std::string(depth, ')'); }

// [a.a. ... .a]: nested tables.
std::string deep_table() {
  std::string text = "[";
  for (int i = 0; i < 500'000; ++i) text += "a.";
  return text + "a]\n";
}

INSTANTIATE_TEST_SUITE_P(Toml, WrongEquationFile,
                         testing::Values(InvalidFile{"end = = 1", 1, 7, "no TOML: "},
                                         InvalidFile{"end = 1\nend = 2\n" + x, 2, 7, "no TOML: "},
                                         InvalidFile{std::string("end = 1\n\0", 9) + x, 2, 1, "no TOML: "},
                                         InvalidFile{"end = 1\nx = " + std::string(1'000'000, '['), 2, 261,
                                                     "no TOML: "},
                                         InvalidFile{deep_table(), 1, 33, "a key of more than 16 parts"},
                                         InvalidFile{"end = 1e400\n" + x, 1, 12, "'1e400'"},
                                         InvalidFile{"\xff\xfe", 1, 1, "no TOML: "}));

INSTANTIATE_TEST_SUITE_P(
    Keys, WrongEquationFile,
    testing::ValuesIn<InvalidFile>(
        {{"", 1, 1, "the file: has no end"},
         {"end = 1", 1, 1, "the file: has no unknown"},
         {with("  unknwon = 1\n" + x), 2, 3,
          "unknwon: no such key of the file, did you mean 'unknown'?; there are title, source, start, end"},
         {with(x + "rsh = 1\n"), 6, 1,
          "rsh: no such key of unknown x, did you mean 'rhs'?; there are size, terms, order, "
          "derivative, chain, factor, rhs, initial, final, before, outside, transfer, input, unless"},
         {with("__proto__ = 1\n" + x), 2, 1, "__proto__: no such key"},
         {with("[unknown]\n"), 2, 1, "there are 0 unknowns: must be 1 to 100"},
         {with("unknown = 3"), 2, 11, "unknown: is a number, must be a table"},
         {with("[unknown]\nx = 3"), 3, 5, "unknown x: is a number, must be a table"},
         {with("[unknown.x]\norder = 1\ninitial = [1]"), 2, 10, "unknown x: has no rhs"},
         {with("[unknown.x]\nrhs = 1\ninitial = [1]"), 2, 10, "unknown x: must have either order or terms"},
         {unknown("order = 1", "true", "[1]"), 4, 7, "rhs: is true or false, must be a number or a formula"},
         {unknown("order = 1", "1", "1"), 5, 11,
          "initial: is a number, must be a list of numbers or formulas"},
         {unknown("terms = [[1, 0.5, 2]]", "1", "[1]"), 3, 10,
          "a term has 3 entries: must be [coefficient, order]"},
         {unknown("terms = []", "1", "[1]"), 3, 9, "terms: has 0 terms"},
         {with("[parameters]\na = \"1\"\n" + x), 3, 5, "a: is a text, must be a number"},
         {with("[parameters]\na = nan\n" + x), 3, 5, "a = nan: must be a finite number"},
         {with("[constraint]\nf = []\n" + x), 3, 5, "f: has 0 formulas"},
         {with("[path]\nx = \"x\"\n" + x), 2, 1, "path has 1 formulas: must be 2 or 3"},
         {with("[energy]\npower = 1\n" + x), 2, 1, "energy: has no value"},
         {with("[[jump]]\n" + x), 2, 1, "jump: has no at"}}));

INSTANTIATE_TEST_SUITE_P(
    Names, WrongEquationFile,
    testing::Values(InvalidFile{with("[unknown.t]\n"), 2, 10, "unknown t: must be another name"},
                    InvalidFile{with("[unknown.D]\n"), 2, 10, "unknown D: must be another name"},
                    InvalidFile{with("[unknown.sin]\n"), 2, 10, "unknown sin: must be another name"},
                    InvalidFile{with("[unknown.energy]\n"), 2, 10, "a column has this one"},
                    InvalidFile{
                        with("[unknown.__proto__]\n"), 2, 10,
                        "unknown __proto__: must be letters, digits and _, at most 64, a letter first"},
                    InvalidFile{with("[unknown.\"x,y\"]\n"), 2, 10, "must be letters, digits and _"},
                    InvalidFile{with("[parameters]\nx = 1\n" + x), 4, 10,
                                "unknown x: must be another name, a parameter has this one"},
                    InvalidFile{with("[parameters]\nuntil = 1\n" + x), 3, 1, "parameter until"},
                    InvalidFile{with("[parameters]\npi = 3\n" + x), 3, 1, "parameter pi"}));

// x' = lambda with x(0) = 1 and the constraint x = a: for a != 1, lambda would not be integrable.
std::string constrained_to(const std::string& a, const std::string& order) {
  return with("[unknown.x]\norder = " + order +
              "\nrhs = \"lambda\"\ninitial = [1]\n[unknown.lambda]\norder = 0\nrhs = \"x - " + a +
              "\"\ninitial = [0]\n");
}

INSTANTIATE_TEST_SUITE_P(Constraints, WrongEquationFile,
                         testing::Values(InvalidFile{
                             constrained_to("0.75", "1"), 8, 8,
                             "is 0.25 at t = 0: must be 0 with these initial values"}));

INSTANTIATE_TEST_SUITE_P(
    Values, WrongEquationFile,
    testing::ValuesIn<InvalidFile>(
        {{"end = 0\n" + x, 1, 7, "end = 0: must be a number in [1e-290, 1e+290]"},
         {"end = \"2*q\"\n" + x, 1, 10, "q: no such name here"},
         {"end = \"t\"\n" + x, 1, 8, "t: no such name here"},
         {"end = inf\n" + x, 1, 7, "end = inf: must be a finite number"},
         {unknown("order = 10.5", "1", "[1, 0, 0]"), 3, 9, "order = 10.5: must be a number in [0, 10]"},
         {unknown("order = -0.5", "1", "[1]"), 3, 9,
          "order = -0.5: must be a number in [0, 10]; the integral of order 0.5 of x is an unknown z"},
         {unknown("order = nan", "1", "[1]"), 3, 9, "order = nan: must be"},
         {unknown("order = \"1/0\"", "1", "[1]"), 3, 10, "order = inf: must be"},
         {unknown("order = 1.5", "1", "[1]"), 2, 10,
          "unknown x: has 1 initial value: must have 2, as its order is 1.5"},
         {unknown("order = 0.5", "1", "[1, 2]"), 2, 10, "has 2 initial values: must have 1"},
         {unknown("order = 0.5", "1", "[\"x\"]"), 5, 13, "x: no such name here"},
         {unknown("terms = [[0, 1.5], [1, 0.5]]", "1", "[1, 0]"), 3, 11,
          "the coefficient of the highest order is 0"},
         {unknown("terms = [[1, 0]]", "1", "[1]"), 3, 14, "the highest order is 0"},
         {with("[[jump]]\nat = -1\n" + x), 3, 6, "at = -1: must be a finite number above 0"}}));

INSTANTIATE_TEST_SUITE_P(
    Formulas, WrongEquationFile,
    testing::ValuesIn<InvalidFile>(
        {{with_rhs("\"-x +\""), 4, 12, "the formula ends"},
         {with_rhs("'-x + yy'"), 4, 13, "yy: no such name here"},
         {with_rhs("'-x**2'"), 4, 11, "'**': must be '^' for a power"},
         {with_rhs("'-x*e^t'"), 4, 11, "e^x is exp(x)"},
         {with_rhs("'D(D(x, 1), 0.5)'"), 4, 10, "D of D: must be of an unknown"},
         {with_rhs("'" + brackets(201) + "'"), 4, 209,
          "brackets, signs and powers are nested more than 200 deep"},
         {with_rhs("\"\\u002dx + yy\""), 4, 18, "yy: no such name here"},
         {with_rhs("\"D(x, 0.7)\""), 4, 8,
          "D(x, 0.7): must be of an order of its chain, 0; an order above those of the terms"},
         {unknown("terms = [[\"2 + sin(t)\", 0.5]]", "1", "[1]"), 3, 12,
          "2 + sin(t): must not vary; a coefficient that does is a factor, or on the right"},
         {unknown("order = \"0.5 + 0.1*x\"", "1", "[1]"), 3, 10,
          "0.5 + 0.1*x: must not vary; orders that do are not supported"},
         {with_rhs("\"-x\n+ 1\""), 4, 10, "between \"\"\" and"},
         {with_rhs("-x"), 4, 7, "a formula stands in quotes"},
         {"end = 1\nkappa0 = 2\n" + x, 2, 1, "a parameter stands under [parameters]"},
         {with("[parameters]\nk = \"2*pi\"\n" + x), 3, 5,
          "k: is a text, must be a number, or k = { formula = ... }"},
         {with_rhs("\"D(y, 0.3)\""), 4, 8, "y: must be an unknown"},
         {with_rhs("\"D(x, t)\""), 4, 8, "D: its order must be a formula of the parameters"},
         {with_rhs("\"gamma(x)\""), 4, 8, "gamma: its argument must be without unknowns"},
         {with(x + "[exact]\nx = \"5 + 0*t\"\n"), 7, 1,
          "exact: x is 5 at t = 0: must be 1, its initial value"},
         {with(x + "[exact]\nz = \"t\"\n"), 7, 1, "exact z: no such column; there are x"},
         {with(x + "[exact]\nx = \"x\"\n"), 7, 6, "x: no such name here; there are t, pi and functions"},
         {with(x + "[energy]\nvalue = \"t*x\"\n"), 7, 10, "t: no such name here"},
         {with(x + "[constraint]\nf = [\"x - \"]\n"), 7, 11, "the formula ends"}}));

// Strings of several lines, with and without escapes; columns count characters.
INSTANTIATE_TEST_SUITE_P(
    FormulasOfSeveralLines, WrongEquationFile,
    testing::ValuesIn<InvalidFile>(
        {{with_rhs("\"\"\"\n-x\n  + yy\"\"\""), 6, 5, "yy: no such name"},
         {with_rhs("'''-x\n\n  + yy'''"), 6, 5, "yy: no such name"},
         {with_rhs("\"\"\"-x \\\n\n    + \\u0032*yy\"\"\""), 6, 14, "yy: no such name"},
         {with_rhs("\"\"\"\r\n-x\r\n + yy\"\"\""), 6, 4, "yy: no such name"},
         {with_rhs("\"-x \u2212 x\""), 4, 11, "here it is -"},
         {with("\"\u00e4\" = 1\n[unknown]\nx = { \"rhs\" = \"yy\" , order = 1, initial = [1] }"), 2, 1,
          "no such key"}}));

INSTANTIATE_TEST_SUITE_P(FormulasBehindAByteOrderMark, WrongEquationFile,
                         testing::Values(InvalidFile{"\xEF\xBB\xBF"
                                                     "end = \"\\u0031 + q\"\n" +
                                                         x,
                                                     1, 17, "q: no such name here"}));

// Keys that other programs have, and these files do not.
INSTANTIATE_TEST_SUITE_P(
    KeysOfOthers, WrongEquationFile,
    testing::ValuesIn<InvalidFile>(
        {{with(x + "history = \"60\"\n"), 6, 1,
          "history: no such key of unknown x; a delay is x(t - tau) in rhs"},
         {with(x + "boundary = [1]\n"), 6, 1,
          "boundary: no such key of unknown x; the value at the end is final = [1.0]"},
         {with(x + "plant = \"1/s\"\n"), 6, 1,
          "plant: no such key of unknown x; a transfer function is transfer ="},
         {with(x + "input = \"1\"\n"), 6, 9, "input: unknown x: must be given with transfer"},
         {with(x + "[event.spike]\nzero = \"x\"\nreset = { x = 1 }\n"), 8, 1,
          "reset: no such key of event spike; what unknowns become at an event is set"}}));

TEST(Formulas, HaveTwoHundredBracketsAtMost) {
  EXPECT_EQ(scene_of_text(relaxation_file("-" + brackets(199))).problem.size(), 1);
  EXPECT_EQ(scene_of_text(relaxation_file(brackets(200))).problem.size(), 1);
}

// gamma means the parameter if no bracket follows.
TEST(Parameters, MayBearTheNameOfAFunction) {
  const Scene scene =
      scene_of_text(relaxation_file("-gamma*x/gamma(2 + gamma)", "1") + "[parameters]\ngamma = 0.25\n");
  Vec f(1);
  scene.problem.rhs(0.0, Vec::Constant(1, 3.0), f);
  EXPECT_DOUBLE_EQ(f[0], -0.75 / std::tgamma(2.25));
}

TEST(WrongEquationFile, IsNotPrintedAsAWhole) {
  expect_message([] { scene_of_text(relaxation_file(std::string(19'000, 'q'))); }, " ...");
  expect_message([] { scene_of_text("end = 1\n" + std::string(500'000, 'q') + " = 1\n"); }, " ...");
}

TEST(MissingEquationFile, IsNamed) {
  const TemporaryFolder folder;
  const std::string place = folder.path();
  for (const std::string command : {"solve", "exact"}) {
    const auto answer = fdebench({command, place + "/no.toml", command == "solve" ? "--scheme" : "--at",
                                  command == "solve" ? "l1" : "1"});
    EXPECT_EQ(answer.code, 2);
  }
  EXPECT_EQ(fdebench({"exact", place + "/no.toml", "--at", "1"}).err,
            "fdebench: " + place + "/no.toml: cannot be read: there is no such file\n");
  std::filesystem::create_directory(folder.path() / "folder.toml");
  EXPECT_THAT(fdebench({"scenes", place + "/folder.toml"}).err, EndsWith("cannot be read: it is no file\n"));
  folder.write("large.toml", std::string((1 << 20) + 1, ' '));
  EXPECT_THAT(fdebench({"scenes", place + "/large.toml"}).err, HasSubstr("must be at most 1048576"));
}

// 1/t at t = 0, and the square root of a negative number during the run.
TEST(EquationThatBreaksDown, IsANumericalFailure) {
  const TemporaryFolder folder;
  folder.write("pole.toml", relaxation_file("-x/t"));
  folder.write("root.toml", relaxation_file("-sqrt(0.5 - t)", "1"));
  for (const std::string file : {"pole.toml", "root.toml"}) {
    EXPECT_THAT(fdebench({"solve", folder.path() / file, "--scheme", "adams_pc", "--steps", "16"}),
                fails_with(3, AllOf(StartsWith("fdebench: adams_pc: "), HasSubstr("step"))))
        << file;
  }
}

// A multiplier like t^-0.5 is integrable, and a difference within rounding is not a jump.
TEST(EquationFiles, BeginOnTheirConstraintsOrWhereAMultiplierTakesThem) {
  const TemporaryFolder folder;
  folder.write("near.toml", constrained_to("(1 - 1e-12)", "1"));
  folder.write("jumps.toml", constrained_to("0.75", "0.5"));
  for (const char* name : {"near.toml", "jumps.toml"}) {
    expect_success(fdebench({"solve", folder.path() / name, "--scheme", "l1", "--steps", "4"}));
  }
}

}  // namespace
}  // namespace fde::bench
