// SPDX-License-Identifier: MIT
// Equation files with values at both ends, against closed forms and series of mpmath.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string ends_file(const std::string& end, const std::string& order, const std::string& rhs,
                      const std::string& initial, const std::string& final) {
  return "end = " + end + "\n[unknown.w]\norder = " + order + "\nrhs = \"" + rhs + "\"\ninitial = [" +
         initial + "]\nfinal = " + final + "\n";
}

CommandOutput run_file(const std::string& text, std::vector<std::string> words,
                       const std::string& settings = "") {
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  words.insert(words.begin() + 1, folder.file("f.toml") + settings);
  return fdebench(words);
}

// D^1.5 w = -w^3, w(0) = 0, w(1) = 1. With w = sum_k c_k t^(1 + 3.5 k), c_(k+1) = -(w^3)_k Gamma(4 + 3.5 k) /
// Gamma(5.5 + 3.5 k), and c_0 such that w(1) = 1, by mpmath with 61 terms: w(1/2), w'(1/2) and w'(0).
const std::string cubic = ends_file("1", "1.5", "-w^3", "0", "[1]");
constexpr double cubic_half = 0.565503466283927323449, cubic_half_slope = 1.07931591508656949356,
                 cubic_slope = 1.14601417598150823743;

struct KnownEnds {
  std::string text;
  double t, value;
};

class ReferenceWithEnds : public testing::TestWithParam<KnownEnds> {};

TEST_P(ReferenceWithEnds, IsThatOfMpmathWithinItsBound) {
  const auto& [text, t, value] = GetParam();
  const Scene scene = scene_of_text(text);
  const auto [found, bound] = reference_of(scene).at(t);
  EXPECT_LE(std::abs(found[0] - value), bound[0] + 1e-16 * std::abs(value));
  EXPECT_LT(bound[0], 1e-12 * (1.0 + std::abs(value)));
}

INSTANTIATE_TEST_SUITE_P(
    AllEnds, ReferenceWithEnds,
    testing::Values(
        // w = w(0) E_1.5(-t^1.5) + w'(0) t E_{1.5,2}(-t^1.5) + 2 t^3.5 E_{1.5,4.5}(-t^1.5).
        KnownEnds{ends_file("2", "1.5", "t^2 - w", "1", "[-1]"), 1.0, -1.53335869062340799076},
        KnownEnds{ends_file("2", "1.5", "t^2 - w", "1", "{ \"D(w, 1)\" = 0.5 }"), 1.0,
                  7.93816704508468425004},
        // w = t, as D^1.5 t = 0.
        KnownEnds{ends_file("1", "1.5", "t - w", "0", "[1]"), 0.3, 0.3},
        // w = a t^2 E_{3.5,3}(-t^3.5) + b t^3 E_{3.5,4}(-t^3.5).
        KnownEnds{ends_file("1", "3.5", "-w", "0, 0", "{ w = 1, \"D(w,1)\" = 0 }"), 0.5,
                  0.497711831182875609686},
        // All values at the end: w = cos(t - 1).
        KnownEnds{ends_file("1", "2", "-w", "", "{ w = 1, \"D(w,1)\" = 0 }"), 0.25, std::cos(0.75)},
        KnownEnds{cubic, 0.5, cubic_half},
        // w'' = 6 w^2 / 4, w(0) = 4, w(1) = 1: w = 4 / (1 + t)^2 (Stoer & Bulirsch, section 7.3.1).
        KnownEnds{ends_file("1", "2", "3/2*w^2", "4", "[1]"), 0.5, 4.0 / 2.25}));

TEST(ValuesAtEnd, AreKnownInManyDigits) {
  const auto answer =
      run_file(ends_file("2", "1.5", "t^2 - w", "1", "[-1]"), {"exact", "--at", "1,2", "--digits", "30"});
  EXPECT_THAT(printed(answer), HasSubstr("1,-1.53335869062340799075089964519"));
  EXPECT_THAT(answer.out, HasSubstr("\n2,-1.0000000000"));
}

// The solution depends smoothly on the missing values, which have the error of the run at the end.
TEST(ValuesAtEnd, EveryRateIsThatOfAnInitialValueProblem) {
  const Scene scene = scene_of_text(cubic);
  for (const auto* scheme : grid_schemes()) {
    if (unsupported_reason(*scheme, scene.problem, Grid{1.0, 32})) continue;
    const auto error = [&](int steps) {
      const auto path = solve(scheme->id, scene.problem, steps, {.output_times = {0.5}});
      EXPECT_EQ(path.status, SolveStatus::finished) << scheme->id;
      return std::abs(path.y(0, 0) - cubic_half);
    };
    const double theory = *theoretical_rate(*scheme, scene.problem, scene.smoothness, 1.0, Norm::end);
    const int steps = theory > 4.9 ? 128 : 512;
    const double coarse = error(steps), fine = error(2 * steps);
    EXPECT_NEAR(std::log2(coarse / fine), theory, 0.2) << scheme->id << ": " << coarse << ", " << fine;
  }
}

TEST(ValuesAtEnd, AdaptiveSchemesKeepTheirTolerance) {
  const Scene scene = scene_of_text(cubic);
  for (const auto* scheme : all_schemes()) {
    if (!scheme->capabilities.is_adaptive()) continue;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const auto path = solve(scheme->id, scene.problem, Tolerance{tolerance, tolerance},
                              {.output_times = {0.0, 0.5, 1.0}});
      ASSERT_EQ(path.status, SolveStatus::finished) << scheme->id;
      EXPECT_NEAR(path.y(1, 0), cubic_slope, 10.0 * tolerance) << scheme->id;
      EXPECT_NEAR(path.y(0, 1), cubic_half, 10.0 * tolerance) << scheme->id;
      EXPECT_NEAR(path.y(1, 1), cubic_half_slope, 10.0 * tolerance) << scheme->id;
      EXPECT_NEAR(path.y(0, 2), 1.0, tolerance) << scheme->id;
    }
  }
}

// u'' = -v, v'' = -u with u(0) = 0, u(1) = sin 1 and v = u given at 0: u = v = sin t.
TEST(ValuesAtEnd, OfOneUnknownOfTwo) {
  const std::string text =
      "end = 1\n[unknown.u]\norder = 2\nrhs = \"-v\"\ninitial = [0]\nfinal = [\"sin(1)\"]\n"
      "[unknown.v]\norder = 2\nrhs = \"-u\"\ninitial = [0, 1]\n";
  const Scene scene = scene_of_text(text);
  const auto [value, bound] = reference_of(scene).at(0.5);
  EXPECT_NEAR(value[0], std::sin(0.5), 1e-15);
  const auto path = solve("bdf4", scene.problem, 400, {.output_times = {0.5}});
  EXPECT_NEAR(path.y(0, 0), std::sin(0.5), 1e-8);
}

class ValuesAtEndWith : public testing::TestWithParam<KnownEnds> {};

TEST_P(ValuesAtEndWith, AreMetBySchemesOfEveryKind) {
  const auto& [text, t, value] = GetParam();
  const Scene scene = scene_of_text(text);
  EXPECT_NEAR(
      solve("spectral_collocation", scene.problem, Tolerance{1e-10, 1e-10}, {.output_times = {t}}).y(0, 0),
      value, 1e-9);
  const auto path = solve("product_trapezoidal", scene.problem, 4000, {.output_times = {t}});
  EXPECT_NEAR(path.y(0, 0), value, 1e-6);
  const auto [known, bound] = reference_of(scene).at(t);
  EXPECT_LE(std::abs(known[0] - value), bound[0] + 1e-15);
}

INSTANTIATE_TEST_SUITE_P(
    OtherParts, ValuesAtEndWith,
    testing::Values(
        // The cubic equation with its unknown in an algebraic row, and as one row of order 1.5.
        KnownEnds{ends_file("1", "1.5", "-y^3", "0", "[1]") +
                      "[unknown.y]\norder = 0\nrhs = \"w + w^3 - y - y^3\"\ninitial = [0]\n",
                  0.5, cubic_half},
        KnownEnds{cubic + "chain = false\n", 0.5, cubic_half},
        // w = sin t, also at earlier times: w'' = w(t - pi).
        KnownEnds{ends_file("4", "2", "w(t - pi)", "0", "[\"sin(4)\"]") + "before = \"sin(t)\"\n", 2.0,
                  std::sin(2.0)},
        // w'' = -J^1/2 D^3/2 t^2 = -2t: w = (4 t - t^3) / 3 with w'(1) = 1/3.
        KnownEnds{ends_file("1", "2", "-J(D(t^2, 1.5), 0.5)", "0", "{ \"D(w,1)\" = \"1/3\" }"), 0.5, 0.625}));

TEST(ValuesAtEnd, OnlyTheLastRunIsObserved) {
  const Scene scene = scene_of_text(cubic);
  std::vector<double> times;
  const auto path = solve("l1", scene.problem, 8, {.observer = [&](double t, In) { times.push_back(t); }});
  EXPECT_EQ(times, path.times);
  EXPECT_EQ(times.size(), 9U);
  const auto alone = solve("l1", with_initial_values(scene.problem, path.y.col(0).tail(1)), 8);
  EXPECT_EQ(path.y, alone.y);
  EXPECT_GT(*path.cost.rhs_calls, 3 * *alone.cost.rhs_calls);
  const auto stopped = solve("l1", scene.problem, 100000, {.budget = 1e-6});
  EXPECT_EQ(stopped.status, SolveStatus::out_of_budget);
}

TEST(ValuesAtEnd, MoveWithTheEnd) {
  const std::string text = ends_file("2", "2", "-w", "0", "[1]");  // w = sin t / sin end
  EXPECT_THAT(printed(run_file(text, {"exact", "--at", "0.5"}, ":until=1")), HasSubstr("0.5,0.56974696366"));
  EXPECT_THAT(printed(run_file(
                  text, {"solve", "--scheme", "bdf4", "--steps", "1000", "--at", "0.5", "--until", "1"})),
              HasSubstr("0.5,0.56974696"));
  EXPECT_THAT(run_file(text + "[exact]\nw = \"sin(t)/sin(2)\"\n", {"exact", "--at", "0.5"}, ":until=1"),
              is_refused(2, HasSubstr("exact: w is 0.925408 at t = 1: must be 1, its value at the end")));
}

TEST(ValuesAtEnd, AProblemWithoutASolutionHasNone) {
  const std::string text = ends_file("1", "2", "-pi^2*w", "0", "[1]");
  for (const auto& how : {std::vector<std::string>{"l1", "--steps", "64"},
                          {"product_trapezoidal", "--steps", "64"},
                          {"bdf4", "--steps", "200"},
                          {"bdf4", "--steps", "1024"},
                          {"radau_exponentials", "--accuracy", "1e-6"},
                          {"spectral_collocation", "--accuracy", "1e-10"},
                          {"spectral_collocation", "--accuracy", "1e-13"}}) {
    std::vector<std::string> words{"solve", "--scheme"};
    words.insert(words.end(), how.begin(), how.end());
    EXPECT_THAT(run_file(text, words), fails_with(3, HasSubstr("the values at the end"))) << how.front();
  }
  EXPECT_THAT(run_file(text, {"exact", "--at", "0.5"}), fails_with(3, HasSubstr("do not determine")));
}

TEST(ValuesAtEnd, AreRefusedWithALine) {
  const auto refused = [](const std::string& text, const std::string& why) {
    EXPECT_THAT(run_file(text, {"solve", "--scheme", "l1", "--steps", "8"}), is_refused(2, HasSubstr(why)));
  };
  refused(ends_file("1", "1.5", "-w", "0, 1", "[1]"),
          "line 2, column 10: unknown w: has 2 initial values and 1 at the end: must have 2 in all, as its "
          "order is 1.5");
  refused(ends_file("1", "1.5", "-w", "0", "{ w = 1, \"D(w,1)\" = 0 }"),
          "has 1 initial value and 2 at the end: must have 2");
  refused(ends_file("1", "2.5", "-w", "0", "[1]"), "has 1 initial value and 1 at the end: must have 3");
  refused(ends_file("1", "1.5", "-w", "0", "[1, 2]"),
          "line 6, column 9: final: has 2 values: must have 1, that of w; derivatives are given in a table");
  refused(ends_file("1", "1.5", "-w", "0", "{ \"D(w,0.7)\" = 1 }"),
          "line 6, column 11: D(w, 0.7): must be of an order of its chain, 0, 1");
  refused(ends_file("1", "1.5", "-w", "0", "{ v = 1 }"), "line 6, column 11: v: no such name here");
  refused(ends_file("1", "1.5", "-w", "0", "{ \"2*w\" = 1 }"),
          "final: 2*w: must be w or one of its derivatives");
  refused(ends_file("1", "2.5", "-w", "0", "{ w = 1, \"D(w,0)\" = 1 }"), "final: D(w,0): must be given once");
  refused(ends_file("1", "0.8", "-w", "", "[1]"),
          "final: the order of w is 0.8: must be above 1 for a value at the end");
  refused(ends_file("1", "0", "1 - w", "", "[1]"), "final: the order of w is 0: must be above 1");
  refused(ends_file("1", "1.5", "-w", "0", "[\"t\"]"), "line 6, column 11: t");
}

}  // namespace
}  // namespace fde::bench
