// SPDX-License-Identifier: MIT
// Delays in equation files, x(t - tau) and before, against solutions that are known.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// y(end) by a scheme with a tolerance of 1e-10 that shares no code with the references.
Vec at_end(const Problem& problem) {
  const auto path = find_scheme("spectral_collocation")
                        ->solve(problem, Tolerance{1e-10, 1e-10}, {.output_times = {problem.end}});
  EXPECT_EQ(path.status, SolveStatus::finished);
  return path.y.rightCols<1>();
}

// D^g x = -x(t - tau), x = 1 before: sum_k (-1)^k (t - (k-1) tau)_+^(k g) / Gamma(k g + 1).
double delayed_decay(double g, double tau, double t) {
  double sum = 0.0;
  for (int k = 0; t - (k - 1) * tau > 0.0; ++k)
    sum += std::pow(-1.0, k) * std::pow(t - (k - 1) * tau, k * g) / std::tgamma(k * g + 1.0);
  return sum;
}

const std::string decay_file =
    "end = 2.5\n[parameters]\ng = 0.6\ntau = 1\n[unknown.x]\norder = \"g\"\nrhs = \"-x(t - tau)\"\ninitial = "
    "[1]\n"
    "before = \"1\"\n";

TEST(DelaysInFiles, AreThoseOfTheSeries) {
  for (const double g : {0.3, 0.6, 1.0}) {
    for (const double tau : {0.4, 1.0, 3.0}) {
      const Scene scene = scene_of_text(decay_file, {{"g", g}, {"tau", tau}});
      EXPECT_NEAR(at_end(scene.problem)[0], delayed_decay(g, tau, 2.5), 1e-9) << g << ' ' << tau;
    }
  }
}

// Each of the two methods looks back at its own solution.
TEST(DelaysInFiles, HaveAReferenceByTwoMethodsWithinItsBound) {
  for (const double g : {0.6, 1.0}) {
    const auto reference = reference_of(scene_of_text(decay_file, {{"g", g}}));
    for (const double t : {0.2, 1.0, 1.3, 2.5}) {
      const auto [value, bound] = reference.at(t);
      EXPECT_NEAR(value[0], delayed_decay(g, 1.0, t), bound[0]) << g << ' ' << t;
      EXPECT_LT(bound[0], 1e-9) << g << ' ' << t;
    }
  }
}

// x = t^2 and y = 1 + t: several delays, of another unknown, of a derivative, in a product and in a factor.
TEST(DelaysInFiles, MayBeOfAnyUnknownAnywhereInARightHandSide) {
  const Scene scene = scene_of_text(
      R"toml(end = 3
[unknown.x]
terms = [[1, 1.5]]
factor = "1 + y(t - 0.5)"
rhs = "2/gamma(1.5)*t^0.5 + x(t - 0.7)*y - (t - 0.7)^2*(1 + t) - x + t^2"
initial = [0, 0]
before = "t^2"
[unknown.y]
order = 1
rhs = "1 + D(x, 1)(t - 1.1)^2 - 4*(t - 1.1)^2 + y(t - 0.5)*x - (0.5 + t)*t^2"
initial = [1]
before = "1 + t"
)toml");
  const Vec end = at_end(scene.problem);
  EXPECT_NEAR(end[0], 9.0, 1e-8);
  EXPECT_NEAR(end[2], 4.0, 1e-8);
  EXPECT_EQ(scene.problem.delays.lags, (std::vector{0.5, 0.7, 1.1}));
}

// x = t^3 solves x''' = 6 + x''(t - 1) - 6 (t - 1) + x'(t - 1) - 3 (t - 1)^2.
TEST(DelaysInFiles, MayBeOfAnyWholeDerivative) {
  const Scene scene = scene_of_text(
      "end = 2\n[unknown.x]\norder = 3\ninitial = [0, 0, 0]\nbefore = \"t^3\"\n"
      "rhs = \"6 + D(x, 2)(t - 1) - 6*(t - 1) + D(x, 1)(t - 1) - 3*(t - 1)^2\"\n");
  EXPECT_NEAR(at_end(scene.problem)[0], 8.0, 1e-8);
}

// 0 = y - x(t - 1): an unknown of an algebraic row, and with it x' = -x(t - 1) as before.
TEST(DelaysInFiles, MayBeInAlgebraicRows) {
  const Scene scene = scene_of_text(
      "end = 2.5\n[unknown.x]\norder = 1\nrhs = \"-y\"\ninitial = [1]\nbefore = \"1\"\n"
      "[unknown.y]\norder = 0\nrhs = \"y - x(t - 1)\"\ninitial = [1]\n");
  const Vec end = at_end(scene.problem);
  for (const std::string scheme : {"product_trapezoidal", "l1"})
    EXPECT_NEAR(solve(scheme, scene.problem, 1000).y(0, 1000), end[0], 2e-3) << scheme;
  EXPECT_NEAR(end[0], delayed_decay(1.0, 1.0, 2.5), 1e-9);
  EXPECT_NEAR(end[1], delayed_decay(1.0, 1.0, 1.5), 1e-9);
}

// y jumps at 0, so f jumps at tau: a grid that contains this time keeps the order of the rule.
TEST(DelaysInFiles, MayJumpAtTheStart) {
  const Scene scene = scene_of_text(
      "end = 2\n[unknown.x]\norder = 1\nrhs = \"-x(t - 0.5)\"\ninitial = [1]\nbefore = \"0\"\n");
  EXPECT_EQ(scene.problem.jump_times, std::vector{0.5});
  // The series with t - k tau in place of t - (k - 1) tau.
  const double exact = 1.0 - 1.5 + 0.5 - 0.5 * 0.5 * 0.5 / 6.0;
  EXPECT_NEAR(at_end(scene.problem)[0], exact, 1e-9);
  EXPECT_NEAR(solve("product_trapezoidal", scene.problem, 400).y(0, 400), exact, 1e-5);
}

// 0.3 + 0.3 + 0.3 is less than 0.9 by rounding.
TEST(DelaysInFiles, MayAddUpToTheEnd) {
  Scene scene = scene_of_text(decay_file, {{"g", 1.0}, {"tau", 0.3}});
  set_end(scene, 0.9);
  const auto [value, bound] = reference_of(scene).at(0.9);
  EXPECT_NEAR(value[0], delayed_decay(1.0, 0.3, 0.9), bound[0]);
  EXPECT_LT(bound[0], 1e-12);
}

// Steps would be no longer than the delay.
TEST(DelaysInFiles, AreNoMillionthOfTheEnd) {
  const Scene scene = scene_of_text(decay_file, {{"tau", 1e-17}});
  EXPECT_EQ(unsupported_reason(*find_scheme("spectral_collocation"), scene.problem, Tolerance{1e-6, 1e-6}),
            "takes delays from 1e-05 of the end on, the shortest is 1e-17");
  EXPECT_THROW(reference_of(scene).at(1.0), std::runtime_error);
}

TEST(DelaysInFiles, WorkInEveryCommand) {
  const TemporaryFolder folder;
  folder.write("f.toml", decay_file);
  const std::string file = folder.file("f.toml");
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "bdf2", "--steps", "200", "--at", "2.5"}).out,
              HasSubstr("2.5,0.3657"));
  EXPECT_THAT(fdebench({"exact", file, "--at", "2.5"}).out, HasSubstr("2.5,0.365734933237996"));
  EXPECT_EQ(fdebench({"choose", file, "--error", "1e-6"}).code, 0);
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "multi_term_pc", "--steps", "200"}).err,
              HasSubstr("takes no delays"));
}

// A file with x of this order, rhs and further lines.
std::string file_of(const std::string& rhs, const std::string& more = "before = \"1\"\n",
                    const std::string& order = "0.5") {
  return relaxation_file(rhs, order) + more;
}

std::string message_about(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  const auto answer = fdebench({"solve", folder.file("f.toml"), "--scheme", "l1", "--steps", "8"});
  EXPECT_EQ(answer.code, 2) << text;
  return answer.err;
}

TEST(DelaysInFiles, AreRefusedInOneLine) {
  const std::string time = "x(...): its time must be t - tau, tau a formula of the parameters above 0";
  for (const std::string rhs : {"x(t - 1 + 0.5*step(t - 2))", "x(t + 1)", "x(2*t - 1)", "x(1)", "x(t - x)",
                                "x(t - t)", "x(t - 0)", "x(-t)"})
    EXPECT_THAT(message_about(file_of(rhs)), HasSubstr(time)) << rhs;
  EXPECT_THAT(message_about(file_of("x(t)")), HasSubstr("x(t) is x"));
  EXPECT_THAT(message_about(file_of("x(t - 1")), HasSubstr("there must be ')', as in x(t - 1)"));
  EXPECT_THAT(message_about(file_of("-x(t - 1)", "")),
              HasSubstr("unknown x: must have the key before, its value for t < 0, as x(t - 1) is needed"));
  EXPECT_THAT(message_about(file_of("-x(t - 1)", "before = \"x\"\n")), HasSubstr("x: no such name here"));
  EXPECT_THAT(message_about(file_of("-step(x(t - 1))")),
              HasSubstr("sign, step and floor of an earlier value are not supported"));
  EXPECT_THAT(message_about(file_of("-x(t - 1)", "before = \"step(t + 0.5)\"\n")),
              HasSubstr("before: must not jump"));
  EXPECT_THAT(message_about(file_of("-x", "before = \"yy\"\n")), HasSubstr("yy: no such name here"));
  EXPECT_THAT(message_about(file_of("-D(x, 0.25)(t - 1)")), HasSubstr("must be of a whole order"));
  EXPECT_THAT(message_about(file_of("-x(t - 1)") + "[energy]\nvalue = \"x(t - 1)\"\n"),
              HasSubstr("earlier values are those of unknowns, in the rhs"));
  EXPECT_THAT(message_about(file_of("-x(t - 1)") + "[columns]\nf = \"D(x, 0.5)\"\n"),
              HasSubstr("must not be a column of a file with delays"));
}

}  // namespace
}  // namespace fde::bench
