// SPDX-License-Identifier: MIT
// Inputs found by fuzzing, each with its message; the fuzz targets are in tests/fuzz.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <tuple>
#include <utility>

#include "fdebench/benchmarks/reference_data/description.hpp"
#include "fdebench/benchmarks/reference_data/reference_check.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(HostileInput, ControlCharactersDoNotReachTheTerminal) {
  EXPECT_THAT(fdebench({"report", "a\x1b[2J\r\x7f", "--out", "x"}),
              fails_with(2, "fdebench: a\\x1b[2J\\x0d\\x7f: cannot be read: No such file or directory\n"));
}

TEST(HostileInput, ANameThatIsTooLongIsNamed) {
  const std::string name(5000, 'a');
  EXPECT_EQ(fdebench({"report", name, "--out", "x"}).err,
            "fdebench: " + name + ": cannot be read: File name too long\n");
  EXPECT_EQ(fdebench({"run", "--scene", "power", "--scheme", "l1", "--steps", "8", "--out", name}).err,
            "fdebench: " + name + ": cannot be written: File name too long\n");
}

TEST(HostileInput, ANumberMayBeginWithMinusAndPoint) {
  EXPECT_EQ(fdebench({"mittag-leffler", "0.5", "1", "-.5"}).out,
            fdebench({"mittag-leffler", "0.5", "1", "-0.5"}).out);
  EXPECT_EQ(fdebench({"mittag-leffler", "0.5", "-.5", "1"}).code, 0);
  EXPECT_EQ(fdebench({"mittag-leffler", "0.5", "1", "-.x"}).code, 2);
}

TEST(HostileInput, TimesBeyondDoubleAreRefused) {
  const auto until = [](const std::string& end) {
    return fdebench({"solve", "relaxation", "--scheme", "l1", "--steps", "8", "--until", end});
  };
  EXPECT_EQ(until("1e308").err, "fdebench: --until = 1e+308: must be a number in [1e-290, 1e+290]\n");
  EXPECT_THAT(until("2.2e307").out, Not(HasSubstr("inf")));
}

TEST(HostileInput, FunctionsBeyondDoubleAreAFailure) {
  for (const auto& words : {std::vector<std::string>{"1", "1", "1000"},
                            {"4.999", "5.3e-315", "-1.07e270,3.2e-322"},
                            {"1", "1", "--matrix", "1,2;3,4000"}}) {
    std::vector<std::string> arguments{"mittag-leffler"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const auto [code, out, err] = fdebench(arguments);
    EXPECT_EQ(code, 3);
    EXPECT_EQ(out, "");
  }
}

// e^200 from mpmath: 87 digits before the point.
TEST(HostileInput, NumbersOfMoreDigitsThanAreUsualAreWhole) {
  EXPECT_THAT(fdebench({"mittag-leffler", "1", "1", "200", "--digits", "100"}).out,
              StartsWith("722597376812574925817747704218930569735687442852731928403269789123221909361473"
                         "891661561.9265890625706 0 "));
  EXPECT_THAT(fdebench({"exact", "power", "--set", "p=1", "--at", "1e90", "--digits", "100"}).out,
              HasSubstr("\n1e+90,1" + std::string(90, '0') + ".000000000,"));
}

TEST(HostileInput, DigitsBeyondAllExponentsAreAFailure) {
  const std::string words = "is beyond all exponents";
  for (const auto& [alpha, z] : {std::pair{"5", "1e308"}, {"0.001", "5"}}) {
    EXPECT_EQ(fdebench({"mittag-leffler", alpha, "1", z, "--digits", "20"}).err,
              "fdebench: the value " + words + "\n");
  }
  const auto [code, out, err] =
      fdebench({"mittag-leffler", "1", "1", "--matrix", "0,0;0,1e300", "--digits", "20"});
  EXPECT_EQ(code, 3) << err;
  EXPECT_EQ(out, "");
  for (const auto& [scene, setting, time] : {std::tuple{"relaxation", "lambda=1", "1e+300"},
                                             {"fractional_constraint_2d", "alpha=1.5", "1e+300"},
                                             {"damped_oscillator", "w2=-1", "1e+100"}}) {
    EXPECT_THAT(fdebench({"exact", scene, "--set", setting, "--at", time, "--digits", "20"}),
                is_refused(3, "fdebench: the exact solution " + words + " at t = " + time + "\n"));
  }
}

TEST(HostileInput, WhatIsSaidOfFiniteColumnsIsFinite) {
  const auto refused = [](const std::string& scene, const std::string& setting, const std::string& time) {
    const auto [code, out, err] = fdebench({"exact", scene, "--set", setting, "--at", time});
    EXPECT_EQ(code, 3) << scene;
    EXPECT_EQ(out, "") << scene;
    return err;
  };
  EXPECT_EQ(refused("damped_oscillator", "u0=1e200", "5"),
            "fdebench: the exact energy is beyond double at t = 5\n");
  EXPECT_EQ(refused("nonholonomic_particle", "y0=1e200", "0"),
            "fdebench: the exact energy is beyond double at t = 0\n");
  EXPECT_EQ(refused("two_sided_constraint", "b1=1.7e308", "1"),
            "fdebench: the exact constraint is beyond double at t = 1\n");
  EXPECT_EQ(refused("rolling_disc", "R=1e30", "1e300"),
            "fdebench: the bound of the exact solution is beyond double at t = 1e+300\n");
}

TEST(HostileInput, AnEmptyArgumentIsNamed) {
  EXPECT_EQ(fdebench({"reference", "", "--every", "2"}).err, "fdebench: argument 2 is empty\n");
  EXPECT_EQ(fdebench({"exact", "", "--at", "1"}).err, "fdebench: argument 2 is empty\n");
  EXPECT_EQ(fdebench({""}).err, "fdebench: argument 1 is empty\n");
}

// Such an order is rounded to 0/M, a chain without nodes.
TEST(HostileInput, AnOrderNextToZeroIsNoMultipleOfOneOverM) {
  const Scene scene = scene_of("pendulum", {{"alpha", 1.0}, {"beta", 5e-324}});
  const auto reason =
      unsupported_reason(*find_scheme("commensurate_adams_pc"), scene.problem, Grid{.end = 1.0, .steps = 8});
  EXPECT_EQ(reason, "needs orders that are multiples of one 1/M with M at most 64");
}

// Opening a pipe for reading would block until it is opened for writing.
TEST(HostileInput, PipesAreNotRead) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "a.csv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT([&] { check_folder(folder.path(), 1, [](std::size_t, std::size_t, const std::string&) {}); },
              ThrowsMessage<std::invalid_argument>(pipe.string() + ": cannot be read: is not a file"));
  EXPECT_EQ(fdebench({"report", pipe.string(), "--out", "x"}).code, 2);
}

TEST(HostileInput, DescriptionsOfOtherTypesAreRefusedInOurWords) {
  EXPECT_THAT([] { parse_description("a.json", R"({"schema": {"version": "x"}})"); },
              ThrowsMessage<std::invalid_argument>(
                  "a.json: is not as docs/reference_data.md says: type must be number, but is string"));
}

}  // namespace
}  // namespace fde::bench
