// SPDX-License-Identifier: MIT
// Tables of samples in equation files. Quoted values: sums of Mittag-Leffler functions of the pieces of the
// load by mpmath with 30 digits; for cubic tables with the spline from a linear system in mpmath, which
// scipy.interpolate.CubicSpline (not-a-knot) confirms.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::DoubleEq;

const std::string samples = "[[0, 0], [0.5, 1.2], [1.1, 0.4], [2, 0.4], [2.7, -1], [5, 1.3]]";

// x of order 0.5 with a table u, x(0) = 0.2.
std::string table_file(const std::string& between, const std::string& rhs = "-x + u(t)",
                       const std::string& points = samples) {
  return "end = 4\n[table.u]\nbetween = \"" + between + "\"\nsamples = " + points +
         "\n[unknown.x]\norder = 0.5\nrhs = \"" + rhs + "\"\ninitial = [0.2]\n";
}

SampledFunction::Pointer function_of(const std::string& between, const std::string& points = samples) {
  return parse_equation_text("test.toml", table_file(between, "-x + u(t)", points)).tables.front();
}

TEST(SampledFunctions, HaveTheLastValueOrTheLineBetweenSamples) {
  const auto constant = function_of("constant"), linear = function_of("linear");
  EXPECT_EQ(constant->at(0.49), 0.0);
  EXPECT_EQ(constant->at(0.5), 1.2);
  EXPECT_EQ(constant->at(5.0), 1.3);
  EXPECT_DOUBLE_EQ(linear->at(0.25), 0.6);
  EXPECT_DOUBLE_EQ(linear->at(1.5), 0.4);
  EXPECT_DOUBLE_EQ(linear->derivative()->at(0.25), 2.4);
  EXPECT_TRUE(std::isnan(linear->at(5.1)) && std::isnan(linear->at(-0.1)) && std::isnan(linear->at(NAN)));
}

TEST(SampledFunctions, HaveTheNotAKnotSpline) {
  const auto spline = function_of("cubic");
  EXPECT_NEAR(spline->at(0.2), 0.88208424527725133, 1e-14);
  EXPECT_NEAR(spline->at(1.5), 0.350560022502038492, 1e-14);
  EXPECT_NEAR(spline->at(4.1), -3.40557950724460476, 1e-14);
  EXPECT_NEAR(spline->derivative()->at(2.3), -1.9556927716981503, 1e-13);
  EXPECT_NEAR(spline->derivative()->derivative()->at(4.1), 7.002650581130739, 1e-13);
}

TEST(SampledFunctions, AreTheCubicThatTheirSamplesAreOn) {
  const auto cubic = function_of("cubic", "[[-1, -1], [0, 0], [0.5, 0.125], [2, 8], [3, 27]]");
  for (const double x : {-0.7, 0.2, 1.0, 2.9}) EXPECT_NEAR(cubic->at(x), x * x * x, 1e-14) << x;
}

TEST(SampledFunctions, AreWithinTheirRangesOverIntervals) {
  for (const auto* between : {"constant", "linear", "cubic"}) {
    for (auto f = function_of(between); f; f = f->derivative()) {
      for (const double width : {0.01, 0.3, 2.0}) {
        for (double low = 0.0; low + width <= 5.0; low += 0.07) {
          const Interval range = f->at(Interval(low, low + width));
          for (const double part : {0.0, 0.21, 0.5, 0.83, 1.0})
            EXPECT_TRUE(range.contains(f->at(low + part * width))) << between << ' ' << low << ' ' << width;
        }
      }
    }
  }
}

TEST(SampledFunctions, BreakWhereTheirPolynomialChanges) {
  EXPECT_THAT(function_of("constant")->breaks(), ElementsAre(0.5, 1.1, 2.7, 5.0));
  EXPECT_THAT(function_of("linear")->breaks(), ElementsAre(0.5, 1.1, 2.0, 2.7));
  EXPECT_THAT(function_of("cubic")->breaks(), ElementsAre(1.1, 2.0));  // not-a-knot
  const auto alternation = function_of("linear")->alternation();
  for (const double x : {0.2, 1.5, 4.0}) EXPECT_LT(alternation->at(x), 0.0) << x;
  for (const double x : {0.6, 2.3}) EXPECT_GT(alternation->at(x), 0.0) << x;
}

std::vector<double> kinks_of(const std::string& rhs, double end = 2.0) {
  Scene scene = scene_of_text(table_file("linear", rhs));
  set_end(scene, end);
  return scene.problem.kink_times;
}

TEST(Tables, BreakAtTheTimesAtWhichTheirArgumentPassesASample) {
  EXPECT_THAT(kinks_of("-x + u(t)"), ElementsAre(0.5, 1.1, 2.0));
  EXPECT_THAT(kinks_of("-x + u(t/2 + 0.4)"), ElementsAre(DoubleEq(0.2), DoubleEq(1.4)));
  EXPECT_THAT(kinks_of("-x + u(4 - t)"), ElementsAre(DoubleEq(1.3), DoubleEq(2.0)));
  EXPECT_THAT(kinks_of("-x + u(t*t/4)"), ElementsAre(DoubleEq(std::sqrt(2.0))));
  EXPECT_THAT(kinks_of("-x + u(x)"), ElementsAre());
  EXPECT_THAT(scene_of_text(table_file("constant")).problem.jump_times, ElementsAre(0.5, 1.1, 2.7));
}

TEST(Tables, OfTimeLeaveAnEquationLinear) {
  for (const auto* between : {"constant", "linear", "cubic"}) {
    EXPECT_TRUE(is_linear(scene_of_text(table_file(between)).problem)) << between;
    EXPECT_FALSE(is_linear(scene_of_text(table_file(between, "-u(x)")).problem)) << between;
    EXPECT_FALSE(is_linear(scene_of_text(table_file(between, "-u(t)*x")).problem)) << between;
  }
}

struct KnownSolution {
  std::string between;
  std::vector<double> values;  // at 0.3, 1, 2.5 and 4
};

const std::vector<KnownSolution> known_solutions{
    {"linear", {0.33426655933853357, 0.48309307101827958, 0.0037024491997232739, 0.088226136134278476}},
    {"constant", {0.11840368226294713, 0.65772881475486531, 0.36412239958773704, -0.49085843120207638}},
    {"cubic", {0.48054901435026126, 0.51401814302821863, 0.085570813845018265, -1.8765998589625865}}};
constexpr std::array known_times{0.3, 1.0, 2.5, 4.0};

// Exact to any number of digits for jumps and kinks, by two methods for a spline.
TEST(Tables, HaveAReferenceWithinItsBound) {
  for (const auto& [between, values] : known_solutions) {
    const Scene scene = scene_of_text(table_file(between));
    EXPECT_EQ(static_cast<bool>(scene.reference.digits), between != "cubic");
    const auto reference = reference_of(scene);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto [value, bound] = reference.at(known_times[i]);
      EXPECT_NEAR(value[0], values[i], bound[0] + 2e-16 * std::abs(values[i]))
          << between << ' ' << known_times[i];
      EXPECT_LT(bound[0], between == "cubic" ? 1e-13 : 1e-15);
    }
  }
}

TEST(Tables, AreSolvedWithinTheToleranceByAdaptiveSchemes) {
  for (const auto& [between, values] : known_solutions) {
    for (const auto* scheme : {"spectral_collocation", "radau_exponentials"}) {
      const Scene scene = scene_of_text(table_file(between));
      const auto path = find_scheme(scheme)->solve(
          scene.problem, Tolerance{1e-8, 1e-8}, {.output_times = {known_times.begin(), known_times.end()}});
      ASSERT_EQ(path.status, SolveStatus::finished);
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(path.y(0, static_cast<Eigen::Index>(i)), values[i], 3e-8) << between << ' ' << scheme;
    }
  }
}

double error_at_end(const Scene& scene, const std::string& scheme, int steps) {
  const auto path =
      find_scheme(scheme)->solve(scene.problem, Grid{.end = scene.problem.end, .steps = steps}, {});
  return std::abs(path.y(0, path.y.cols() - 1) - reference_of(scene).at(scene.problem.end).value[0]);
}

struct TableRate {
  std::string between, scheme;
  double rate;
};

// With the samples among the grid times the rates at the end are those of a smooth load: those of the scheme,
// at most 1 + 0.5 where the start like t^0.5 limits it.
TEST(Tables, KeepTheRatesOfSchemesOnGridsWithTheirSamples) {
  const std::string
      head = "end = 1\n[table.u]\nsamples = [[0, 0.3], [0.25, 1.2], [0.5, -0.4], [0.75, 0.8], [1, 0.1]]\n",
      rows = "[unknown.x]\norder = 0.5\nrhs = \"-3*x + u(t)\"\ninitial = [2]\n";
  for (const auto& [between, scheme, rate] : std::vector<TableRate>{{"constant", "bdf2", 2.0},
                                                                    {"constant", "product_trapezoidal", 1.5},
                                                                    {"constant", "l1", 1.0},
                                                                    {"constant", "grunwald_letnikov", 1.0},
                                                                    {"linear", "bdf2", 2.0},
                                                                    {"linear", "product_trapezoidal", 1.5},
                                                                    {"linear", "l1", 1.0},
                                                                    {"linear", "grunwald_letnikov", 1.0},
                                                                    {"cubic", "bdf2", 2.0},
                                                                    {"cubic", "grunwald_letnikov", 1.0}}) {
    const Scene scene = scene_of_text(fmt::format("{}between = \"{}\"\n{}", head, between, rows));
    double coarse = error_at_end(scene, scheme, 1024);
    for (const int steps : {2048, 4096, 8192, 16384}) {
      const double fine = error_at_end(scene, scheme, steps);
      EXPECT_NEAR(std::log2(coarse / fine), rate, 0.07) << between << ' ' << scheme << ' ' << steps;
      coarse = fine;
    }
  }
}

// Off the grid a jump costs a part of a step, and a kink a part of its square.
TEST(Tables, CostAPartOfAStepWhereTheirSamplesAreOffTheGrid) {
  const std::string points = "[[0, 0.3], [0.947, 1.2], [2.063, -0.4], [3.077, 0.8], [4, 0.1]]";
  for (const auto& [between, power] : {std::pair("constant", 1.0), std::pair("linear", 2.0)}) {
    const Scene scene = scene_of_text(table_file(between, "-x + u(t)", points));
    for (const int steps : {512, 1024, 2048, 4096}) {
      EXPECT_LT(error_at_end(scene, "bdf2", steps), 0.5 * std::pow(4.0 / steps, power))
          << between << ' ' << steps;
    }
  }
}

// The same problem with max for the kinks: D^0.7 x = -k(x) + u(t).
TEST(Tables, OfUnknownsAreTheirPiecewiseFormulas) {
  const std::string head = "end = 4\n[table.u]\nsamples = " + samples +
                           "\n[table.k]\nsamples = [[-5, -2], [-1, -0.5], [0, 0], [1, 2], [5, 3]]\n";
  const std::string body = "[unknown.x]\norder = 0.7\ninitial = [0.5]\nrhs = ";
  const Scene table = scene_of_text(head + body + "\"-k(x) + u(t)\"\n");
  const Scene formula = scene_of_text(
      "end = 4\n" + body +
      "\"-(-2 + 0.375*(x + 5) + 0.125*max(x + 1, 0) + 1.5*max(x, 0) - 1.75*max(x - 1, 0)) + 2.4*t - "
      "(0.8/0.6 + 2.4)*max(t - 0.5, 0) + 0.8/0.6*max(t - 1.1, 0) - 2*max(t - 2, 0) + 3*max(t - 2.7, 0)\"\n");
  const reference::Reference of_table = reference_of(table), of_formula = reference_of(formula);
  for (const double t : {0.3, 1.0, 2.5, 4.0}) {
    const auto one = of_table.at(t), other = of_formula.at(t);
    EXPECT_NEAR(one.value[0], other.value[0], one.bound[0] + other.bound[0]) << t;
    EXPECT_LT(one.bound[0], 1e-10);
  }
}

// Between samples of x the table is constant, and jumps where x crosses one: D^0.9 x = 1 - x/2 + k(x).
TEST(Tables, OfUnknownsThatJumpAreSwitches) {
  const std::string body = "[unknown.x]\norder = 0.9\ninitial = [0]\nrhs = ";
  const Scene table = scene_of_text(
      "end = 4\n[table.k]\nbetween = \"constant\"\nsamples = [[-5, 0], [0.25, 0.5], [0.75, 1], [9, 1]]\n" +
      body + "\"1 - x/2 + k(x)\"\n");
  const Scene formula =
      scene_of_text("end = 4\n" + body + "\"1 - x/2 + step(x - 0.25)/2 + step(x - 0.75)/2\"\n");
  const auto end_of = [](const Scene& scene) {
    const auto path = find_scheme("radau_exponentials")
                          ->solve(scene.problem, Tolerance{1e-9, 1e-9}, {.output_times = {4.0}});
    EXPECT_EQ(path.status, SolveStatus::finished);
    return path.y(0, path.y.cols() - 1);
  };
  EXPECT_NEAR(end_of(table), end_of(formula), 1e-8);
}

// D^0.5 and J^0.5 of the load 2 t: 2 t^0.5/Gamma(1.5) and 2 t^1.5/Gamma(2.5).
TEST(Tables, HaveIntegralsAndDerivatives) {
  const std::string line = "[[0, 0], [1, 2], [4, 8]]";
  const auto at_end = [&](const std::string& rhs, const std::string& between) {
    return reference_of(scene_of_text(table_file(between, rhs, line + "\n"))).at(4.0).value[0];
  };
  EXPECT_NEAR(at_end("D(u(t), 0.5) - x", "linear"), at_end("2*t^0.5/gamma(1.5) - x", "linear"), 1e-12);
  EXPECT_NEAR(at_end("J(u(t), 0.5) - x", "linear"), at_end("2*t^1.5/gamma(2.5) - x", "linear"), 1e-12);
  EXPECT_THROW(at_end("D(u(t), 0.5) - x", "constant"), FileError);
  EXPECT_THROW(at_end("D(u(t), 1.5) - x", "linear"), FileError);
}

// x = u(t) solves x' = u'(t) + u(t) - x, to any number of digits: u(0.3) = 0.72.
TEST(Tables, AreColumnsOfExactSolutions) {
  const TemporaryFolder folder;
  folder.write("exact.toml", "end = 4\n[table.u]\nsamples = " + samples +
                                 "\n[unknown.x]\norder = 1\nrhs = \"D(u(t), 1) + u(t) - x\"\ninitial = [0]\n"
                                 "[exact]\nx = \"u(t)\"\n");
  EXPECT_THAT(fdebench({"exact", folder.file("exact.toml"), "--at", "0.3,1", "--digits", "30"}).out,
              AllOf(HasSubstr("0.3,0.72000000000000000000000000000"),
                    HasSubstr("1,0.53333333333333333333333333333")));
}

TEST(Tables, MeanTheContentsOfTheirCsvFile) {
  const TemporaryFolder folder;
  const auto written = [&](const std::string& csv) {
    folder.write("u.csv", csv);
    folder.write("file.toml",
                 "end = 4\n[table.u]\nfile = \"u.csv\"\n" + relaxation_file("-x + u(t)").substr(8));
    return equation_scene(read_equation_text(folder.file("file.toml"))).checksum;
  };
  const auto inlined =
      maker_of("end = 4\n[table.u]\nsamples = [[0, 1], [4, 2.5]]\n" + relaxation_file("-x + u(t)").substr(8))
          .checksum;
  EXPECT_EQ(written("t,u\n0,1\n4,2.5\n"), inlined);
  EXPECT_EQ(written("\xEF\xBB\xBFtime,load\r\n0, 1.0\r\n\r\n4,2.50\r\n"), inlined);
  EXPECT_NE(written("t,u\n0,1\n4,2.6\n"), inlined);
}

std::string refusal_of(const std::string& text) {
  try {
    scene_of_text(text);
    return "none";
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
}

TEST(Tables, AreRefusedWhereTheirArgumentLeavesTheSamples) {
  const auto refusal = [](const std::string& value) {
    return refusal_of(table_file("linear", "-x + " + value));
  };
  EXPECT_EQ(refusal("u(2*t)"),
            "test.toml: line 7, column 13: u(2*t): 2*t = 8 at t = 4: must be at most 5, the last sample of "
            "table u");
  EXPECT_THAT(refusal("u(t - 1)"), HasSubstr("t - 1 = -1 at t = 0: must be at least 0, the first sample"));
  EXPECT_THAT(refusal("u(t*t)"), HasSubstr("at t = 4: must be at most 5"));
  EXPECT_THAT(refusal("u(7)"), HasSubstr("u(7): 7: must be at most 5"));
  EXPECT_EQ(refusal("u(5*sin(t)^2)"), "none");
  Scene longer = scene_of_text(table_file("linear"));
  EXPECT_THROW(set_end(longer, 6.0), FileError);
}

TEST(Tables, AreRefusedWithTheirPlace) {
  const auto refusal = [](const std::string& points, const std::string& between = "linear",
                          const std::string& rhs = "-x + u(t)") {
    return refusal_of(table_file(between, rhs, points));
  };
  EXPECT_THAT(refusal("[[0, 1], [0, 2]]"),
              HasSubstr("line 4, column 21: 0: must be above 0, the argument before"));
  EXPECT_THAT(refusal("[[0, 1]]"), HasSubstr("must be at least 2"));
  EXPECT_THAT(refusal("[[0, 1], [4, 2]]", "cubic"), HasSubstr("must be at least 4"));
  EXPECT_THAT(refusal("[[0, 1], [4, 2, 3]]"), HasSubstr("line 4, column 20: a sample has 3 entries"));
  EXPECT_THAT(refusal(samples, "square"),
              HasSubstr("between: must be \"constant\", \"linear\" or \"cubic\""));
  EXPECT_THAT(refusal(samples, "linear", "-x + u"), HasSubstr("u being a table, as in u(t)"));
  for (const auto* name : {"x", "J", "sin", "t", "pi"}) {
    EXPECT_THAT(refusal_of(fmt::format("end = 4\n[table.{}]\nsamples = [[0, 1], [4, 2]]\n{}", name,
                                       relaxation_file("-x").substr(8))),
                HasSubstr("must be another name"))
        << name;
  }
}

TEST(Tables, OfCsvFilesAreRefusedWithLineAndCell) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& csv) {
    folder.write("u.csv", csv);
    folder.write("file.toml",
                 "end = 4\n[table.u]\nfile = \"u.csv\"\n" + relaxation_file("-x + u(t)").substr(8));
    return fdebench({"solve", folder.file("file.toml"), "--scheme", "l1", "--steps", "8"});
  };
  EXPECT_THAT(refusal("t,u\n0,1\n1,two\n"),
              is_refused(2, HasSubstr("u.csv: line 3, column 2: two: must be a number")));
  EXPECT_THAT(refusal("t,u\n0,1\n1,2\n0.5,3\n"),
              is_refused(2, HasSubstr("u.csv: line 4, column 1: 0.5: must be above 1")));
  EXPECT_THAT(refusal("t,u\n0,1,2\n"),
              is_refused(2, HasSubstr("u.csv: line 2, column 1: the number of cells is 3")));
  EXPECT_THAT(refusal("0,1\n1,2\n"),
              is_refused(2, HasSubstr("u.csv: line 1, column 1: 0,1: must be a header")));
  EXPECT_THAT(refusal("t,u\n0,1\n3,2\n"),
              is_refused(2, HasSubstr("u(t): t = 4: must be at most 3, the last sample of u.csv")));
}

TEST(Tables, OfUnknownsThatLeaveTheSamplesEndTheRun) {
  const TemporaryFolder folder;
  folder.write("leaves.toml", table_file("linear", "9 + u(x)"));
  const auto result = fdebench({"solve", folder.file("leaves.toml"), "--scheme", "l1", "--steps", "64"});
  EXPECT_EQ(result.code, 3);
  EXPECT_THAT(result.err, HasSubstr("l1: not finite at step"));
}

TEST(Tables, MayHaveThousandsOfSamples) {
  std::string points = "[[0, 0]";
  for (int i = 1; i <= 20'000; ++i)
    points += ", [" + std::to_string(i) + "e-3, " + std::to_string(i % 2) + "]";
  const Scene scene = scene_of_text(table_file("linear", "-x + u(5*t)", points + "]"));
  EXPECT_EQ(scene.problem.kink_times.size(), 19'999U);
  const auto path = find_scheme("bdf2")->solve(scene.problem, Grid{.end = 4.0, .steps = 20'000}, {});
  EXPECT_EQ(path.status, SolveStatus::finished);
}

}  // namespace
}  // namespace fde::bench
