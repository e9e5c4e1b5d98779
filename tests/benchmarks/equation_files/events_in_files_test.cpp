// SPDX-License-Identifier: MIT
// Events of equation files: zeros that `solve` locates and that may end it.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "benchmarks/equation_files/file_commands.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr std::array locating_schemes{"spectral_collocation", "radau_exponentials", "adaptive_trapezoidal",
                                      "adaptive_pc"};

const std::string falling = "solve " + example("falling.toml");

// The sphere of docs/examples, with a closed form: halfway it is at 1/2, on the ground at 0.
TEST(EventsOfAFile, ArePrintedWithTheirTimes) {
  const auto answer = printed(fdebench(falling + " --scheme spectral_collocation --accuracy 1e-12 --events"));
  EXPECT_THAT(answer, StartsWith("event,t,x,\"D(x,1)\",\"D(x,1.5)\"\nhalfway,"));
  EXPECT_THAT(answer, HasSubstr("\nground,"));
  const Scene scene = scene_of_example("falling.toml");
  const auto path = find_scheme("spectral_collocation")
                        ->solve(scene.problem, Tolerance{1e-12, 1e-12}, {.events = events_of(scene)});
  ASSERT_EQ(path.events.size(), 2U);
  EXPECT_NEAR(scene.reference.at(path.events[0].t).value[0], 0.5, 1e-11);
  EXPECT_NEAR(scene.reference.at(path.events[1].t).value[0], 0.0, 1e-11);
}

TEST(EventsOfAFile, EndASolveInGoodOrder) {
  for (const auto* scheme : {"spectral_collocation", "radau_exponentials", "adaptive_trapezoidal"}) {
    const auto answer =
        fdebench({"solve", example("falling.toml"), "--scheme", scheme, "--accuracy", "1e-6"});
    EXPECT_EQ(answer.code, 0);
    EXPECT_THAT(answer.err, StartsWith("fdebench: event ground ended the run at t = "));
    const auto last = csv_rows(answer.out).back();
    EXPECT_NEAR(last[1], 0.0, 1e-12) << scheme;
    EXPECT_NEAR(scene_of_example("falling.toml").reference.at(last[0]).value[0], 0.0, 1e-5) << scheme;
  }
}

TEST(EventsOfAFile, EndASolveBeforeTimesThatAreAskedFor) {
  const auto answer = fdebench(falling + " --scheme spectral_collocation --accuracy 1e-6 --at 0.5,1,9,10");
  EXPECT_EQ(answer.code, 0);
  ASSERT_EQ(csv_rows(answer.out).size(), 2U);
  EXPECT_EQ(csv_rows(answer.out)[1][0], 1.0);
}

// The logarithm of a negative number.
TEST(EventsOfAFile, ThatAreNeverANumberAreSaid) {
  const TemporaryFolder folder;
  folder.write("never.toml", relaxation_file("-x") + "[event.never]\nzero = \"log(-1 - x^2)\"\n");
  const auto answer = fdebench({"solve", folder.path() / "never.toml", "--scheme", "spectral_collocation",
                                "--accuracy", "1e-6", "--events"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.err, HasSubstr("warning: event never is not a number at any time of the run"));
}

TEST(EventsOfAFile, AreNotLocatedOverAGridWhichIsSaid) {
  const auto answer = fdebench(falling + " --scheme l1 --steps 64");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.err, HasSubstr("event ground does not end this run: l1 steps over a grid"));
  EXPECT_EQ(csv_rows(answer.out).back()[0], 10.0);
  EXPECT_EQ(fdebench(falling + " --scheme l1 --steps 64 --strict").code, 3);
}

// An event is not part of the equation.
TEST(EventsOfAFile, LeaveTheReferenceAsItIs) {
  EXPECT_EQ(fdebench("exact " + example("falling.toml") + " --at 10").code, 0);
}

TEST(EventsOfAFile, ArePrintedWhereThereAreSome) {
  const auto line = [](const std::string& words) {
    const auto answer = fdebench(words);
    EXPECT_EQ(answer.code, 2);
    return answer.err;
  };
  EXPECT_THAT(line("solve relaxation --scheme adaptive_pc --accuracy 1e-3 --events"), HasSubstr("has none"));
  EXPECT_THAT(line(falling + " --scheme l1 --steps 64 --events"), HasSubstr("only taken with --accuracy"));
  EXPECT_THAT(line(falling + " --scheme adaptive_pc --accuracy 1e-3 --events --at 1"),
              HasSubstr("not taken with --at"));
}

// Errors in an event are reported like all others: file, line and column.
TEST(EventsOfAFile, AreRefusedInOneLine) {
  const auto line = [](const std::string& event) {
    const TemporaryFolder folder;
    folder.write("f.toml", relaxation_file("-x") + "[event.low]\n" + event + "\n");
    const std::string file = folder.file("f.toml");
    const auto answer = fdebench("solve " + file + " --scheme adaptive_pc --accuracy 1e-3");
    EXPECT_EQ(answer.code, 2) << event;
    EXPECT_EQ(answer.out, "");
    return answer.err.substr(std::string("fdebench: " + file).size());
  };
  EXPECT_THAT(line("ends = true"), StartsWith(": line 6, column 8: event low: has no zero"));
  EXPECT_THAT(line("zero = \"y - 1\""), StartsWith(": line 7, column 9: y: no such name"));
  EXPECT_THAT(line("zero = \"x\"\ncrossing = \"up\""), StartsWith(": line 8, column 12: crossing: must be"));
  EXPECT_THAT(line("zero = \"x\"\ncrossing = 1"), StartsWith(": line 8, column 12: crossing"));
  EXPECT_THAT(line("zero = \"x\"\nends = 1"), StartsWith(": line 8, column 8: ends"));
  EXPECT_THAT(line("zero = \"x\"\nat = 1"), HasSubstr("line 8"));
}

std::string dosed(const std::string& set) {
  return "end = 2\n[unknown.x]\norder = 0.6\nrhs = \"-x\"\ninitial = [1]\n[event.dose]\nzero = \"t - 1\"\n" +
         set;
}

// x' = 1 with half of x taken at each zero of sin(5.13 t), z and 2 z up to the end: a step up to the end
// would be exact, and see no change of sign.
TEST(EventsOfAFile, AreNotPassedOverInPairs) {
  constexpr double start = 0.334, end = 1.5, z = std::numbers::pi / 5.13;
  const TemporaryFolder folder;
  folder.write("line.toml",
               fmt::format("end = {}\n[unknown.x]\norder = 1\nrhs = \"1\"\ninitial = [{}]\n[event.half]\n"
                           "zero = \"sin(5.13*t)\"\nset = {{ x = \"x/2\" }}\n",
                           end, start));
  const std::string file = folder.path() / "line.toml";
  for (const auto* scheme : locating_schemes) {
    const auto answer = fdebench({"solve", file, "--scheme", scheme, "--accuracy", "1e-7", "--at", "1.5"});
    EXPECT_NEAR(csv_rows(answer.out).back()[1], ((start + z) / 2.0 + z) / 2.0 + end - 2.0 * z, 1e-7)
        << scheme;
  }
}

// x' jumps from 0 to 1 where half of x = 1 is taken.
TEST(EventsOfAFile, MayBeAtAJumpOfTheEquation) {
  const std::string file =
      "end = 2\n[unknown.x]\norder = 1\nrhs = \"step(t - 1)\"\ninitial = [1]\n[event.half]\nzero = \"t - "
      "1\"\n"
      "set = { x = \"x/2\" }\n";
  for (const auto* scheme : locating_schemes) {
    const auto run = command(file, {"solve", "--scheme", scheme, "--accuracy", "1e-7", "--at", "2"});
    EXPECT_NEAR(values(run)[1], 1.5, 1e-9) << scheme;
  }
}

// x = t passes 1 and 1.01, y becomes y + 1 at each zero that counts; every scheme solves both rows by steps
// that are longer than the time between.
TEST(EventsOfAFile, AreNotPassedOverInPairsWhereTheyDependOnUnknowns) {
  const std::string line =
      "end = 3\n[unknown.x]\norder = 1\nrhs = \"1\"\ninitial = [0]\n[unknown.y]\norder = 0.6\nrhs = \"0\"\n"
      "initial = [0]\n[event.within]\nzero = \"(x - 1)*(x - 1.01)\"\nset = { y = \"y + 1\" }\n";
  for (const auto* scheme : locating_schemes) {
    const auto at_end = [&](const std::string& file) {
      return values(command(file, {"solve", "--scheme", scheme, "--accuracy", "1e-6", "--at", "3"}))[2];
    };
    EXPECT_NEAR(at_end(line), 2.0, 1e-9) << scheme;
    EXPECT_NEAR(at_end(line + "crossing = \"rising\"\n"), 1.0, 1e-9) << scheme;
  }
}

// x' = 1 + step of a function that is positive between x = 1 and x = 1.01: x runs through it in half the
// time.
TEST(SwitchesOfAFile, AreNotPassedOverInPairs) {
  const std::string line =
      "end = 3\n[unknown.x]\norder = 1\nrhs = \"1 + step((x - 1)*(1.01 - x))\"\ninitial = [0]\n";
  for (const auto* scheme : locating_schemes) {
    const auto run = command(line, {"solve", "--scheme", scheme, "--accuracy", "1e-7", "--at", "3"});
    EXPECT_NEAR(values(run)[1], 3.005, 1e-6) << scheme;
  }
}

// The zeros 1 - z and 1 + z, z = 1e-4 sqrt(log 2), are far closer to each other than steps and their samples.
TEST(EventsOfAFile, OfTimeAloneAreFoundHoweverCloseTheyAre) {
  const std::string file =
      "end = 2\n[unknown.x]\norder = 0.5\nrhs = \"-x\"\ninitial = [1]\n[event.pulse]\nzero = \"exp(-((t - "
      "1)/1e-4)^2) - 0.5\"\n";
  const double z = 1e-4 * std::sqrt(std::numbers::ln2);
  for (const auto* scheme : locating_schemes) {
    const auto answer = command(file, {"solve", "--scheme", scheme, "--accuracy", "1e-3", "--events"});
    const auto row = answer.out.find("pulse,"), second = answer.out.find("pulse,", row + 1);
    ASSERT_NE(second, std::string::npos) << scheme;
    EXPECT_NEAR(std::stod(answer.out.substr(row + 6)), 1.0 - z, 1e-12) << scheme;
    EXPECT_NEAR(std::stod(answer.out.substr(second + 6)), 1.0 + z, 1e-12) << scheme;
  }
}

// Half of x is taken at t = 1, which decays as x does: x(2) = E(-2^0.6) - E(-1) E(-1)/2, E(z) = E_0.6,1(z).
TEST(EventsOfAFile, SetUnknowns) {
  const TemporaryFolder folder;
  folder.write("dose.toml", dosed("set = { x = \"x/2\" }\n"));
  const std::string file = folder.path() / "dose.toml";
  const auto decay = [](double z) { return reference::mittag_leffler(0.6, 1.0, z); };
  const double expected = decay(-std::pow(2.0, 0.6)) - decay(-1.0) * decay(-1.0) / 2.0;
  for (const auto* scheme : {"spectral_collocation", "radau_exponentials", "adaptive_trapezoidal"}) {
    const auto answer = fdebench({"solve", file, "--scheme", scheme, "--accuracy", "1e-7", "--at", "2"});
    EXPECT_EQ(answer.err, "") << scheme;
    EXPECT_NEAR(csv_rows(answer.out).back()[1], expected, 2e-6) << scheme;
  }
  const auto events =
      fdebench({"solve", file, "--scheme", "spectral_collocation", "--accuracy", "1e-9", "--events"});
  EXPECT_THAT(events.out, AllOf(StartsWith("event,t,x\ndose,"),
                                HasSubstr(fmt::format(",{:.8f}", decay(-1.0)).substr(0, 8))));
  const auto known = csv_rows(printed(fdebench({"exact", file, "--at", "1,2"})));
  EXPECT_NEAR(known[0][1], decay(-1.0), known[0][2]);
  EXPECT_NEAR(known[1][1], expected, known[1][2]);
  EXPECT_LT(known[1][2], 1e-13);
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "l1", "--steps", "8"}).err,
              HasSubstr("locates no events"));
  EXPECT_THAT(printed(fdebench({"choose", file, "--error", "1e-4"})), HasSubstr("--accuracy"));
}

TEST(EventsOfAFile, SetOnlyRowsWithDerivatives) {
  const auto refusal = [](const std::string& set) {
    const TemporaryFolder folder;
    folder.write("dose.toml", dosed(set));
    return fdebench(
               {"solve", folder.path() / "dose.toml", "--scheme", "radau_exponentials", "--accuracy", "1e-3"})
        .err;
  };
  EXPECT_THAT(refusal("set = { y = 1 }\n"), HasSubstr("line 8, column 9: y: no such name here"));
  EXPECT_THAT(refusal("set = { t = 1 }\n"), HasSubstr("set: t: must be an unknown with a derivative"));
  EXPECT_THAT(refusal("set = { \"D(x, 0.3)\" = 1 }\n"), HasSubstr("must be of an order of its chain"));
  EXPECT_THAT(refusal("set = { x = 1 }\nends = true\n"),
              HasSubstr("set: must not be given with ends = true"));
  EXPECT_THAT(refusal("set = { x = 1 }\n[unknown.w]\norder = 0\nrhs = \"w - x\"\ninitial = [1]\n[event.b]\n"
                      "zero = \"t - 1.5\"\nset = { w = 1 }\n"),
              HasSubstr("set: w: must be an unknown with a derivative"));
}

}  // namespace
}  // namespace fde::bench
