// SPDX-License-Identifier: MIT
// Transfer functions of real powers of s in equation files.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/equation_files/file_commands.hpp"
#include "support/command_output.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string plant(std::string_view transfer, std::string_view input = "1") {
  return fmt::format("end = 5\n[unknown.y]\ntransfer = \"{}\"\ninput = \"{}\"\n", transfer, input);
}

// The plant of Podlubny, IEEE Trans. Automat. Control 44 (1999), with his PD^mu controller.
constexpr std::string_view closed_loop =
    "(20.5 + 3.7343*s^1.15)/(0.8*s^2.2 + 3.7343*s^1.15 + 0.5*s^0.9 + 21.5)";

struct Response {
  std::string_view transfer, input, t;
  double value;
};

// Inverse Laplace transforms by mpmath (invertlaplace, Talbot's method of degree 90, 40 digits).
constexpr std::array responses{
    Response{closed_loop, "1", "0.1", 0.38499408812182508869},
    Response{closed_loop, "1", "2.5", 0.95689587498300593186},
    Response{"1/(s^0.5 + 1)^3", "1", "2", 0.24234110448134222178},
    Response{"(2 + 1/s^0.6)/(s^1.3 + s^0.6 + 1/3)", "1", "2", 2.6911487917309496635}};

TEST(TransferFunctions, HaveTheirInverseTransformAsReference) {
  for (const auto& [transfer, input, t, value] : responses) {
    const auto row = exact(plant(transfer, input), t);
    EXPECT_NEAR(row[1], value, 1e-15 * (1.0 + std::abs(value))) << transfer;
    EXPECT_LT(row[2], 1e-15) << transfer;
  }
}

// By two methods, as the input is no sum of powers.
TEST(TransferFunctions, TakeAnyInput) {
  const auto row = exact(plant("1/((0.4*s)^0.8 + 1)", "sin(3*t)"), "2");
  EXPECT_NEAR(row[1], -0.45657125047733019676, row[2]);
  EXPECT_LT(row[2], 1e-11);
}

// A transfer function is the state z with a sum of its derivatives as the column, and a common power of s is
// left out.
TEST(TransferFunctions, AreStatesWithASumAsOutput) {
  const std::string by_hand =
      "end = 5\n[unknown.z]\nterms = [[1, 1.3], [1, 0.6], [\"1/3\", 0]]\nrhs = \"1\"\ninitial = [0, 0]\n"
      "[columns]\ny = \"2*z + D(z, 0.6)\"\n";
  const std::array same{plant("(2 + s^0.6)/(s^1.3 + s^0.6 + 1/3)"),
                        plant("(2*s^-1 + s^-0.4)/(s^0.3 + s^-0.4 + 1/(3*s))"),
                        plant("(2 + s^0.6)/(s^1.3 + s^0.6 + 1/3)^2*(s^1.3 + s^0.6 + 1/3)")};
  const auto expected = exact(by_hand, "1.7");
  for (const auto& text : same) EXPECT_NEAR(exact(text, "1.7")[1], expected[1], 1e-14) << text;
  const std::vector<std::string> solve{"solve", "--scheme", "bdf2", "--steps", "64", "--at", "5"};
  EXPECT_EQ(values(command(same[0], solve)), values(command(by_hand, solve)));
}

// K (1 - y) - T D^m y into 1/Q is K/(Q + K + T s^m) into 1: an output feeds back, with its derivatives.
TEST(TransferFunctions, FeedBack) {
  const auto open = plant("1/(0.8*s^2.2 + 0.5*s^0.9 + 1)", "20.5*(1 - y) - 3.7343*D(y, 1.15)");
  const auto closed = plant("20.5/(0.8*s^2.2 + 3.7343*s^1.15 + 0.5*s^0.9 + 21.5)");
  EXPECT_NEAR(exact(open, "1.25")[1], exact(closed, "1.25")[1], 1e-15);
  const auto digits = [](const std::string& text) {
    return command(text, {"exact", "--at", "1.25", "--digits", "25"}).out.substr(0, 40);
  };
  EXPECT_EQ(digits(open), digits(closed));
}

// Before t = tau a loop with the delay tau is open, and so is the plant at rest.
TEST(TransferFunctions, AreAtRestBeforeTheStart) {
  const std::vector<std::string> solve{"solve", "--scheme", "spectral_collocation", "--accuracy", "1e-10",
                                       "--at",  "0.5"};
  const auto looped = values(command(plant("(1 + s^0.3)/(s^0.9 + 1)", "1 - y(t - 0.5)"), solve));
  EXPECT_NEAR(looped[1], exact(plant("(1 + s^0.3)/(s^0.9 + 1)"), "0.5")[1], 1e-10);
}

// The rates of smooth states, which start at rest like t^2.2: bdf2 2, Gruenwald-Letnikov 1.
TEST(TransferFunctions, KeepTheRatesOfTheirStates) {
  const auto text = plant("(1 + s^0.5)/(s^1.2 + s^0.5 + 2)", "t");
  const double reference = exact(text, "5")[1];
  const auto error = [&](const std::string& scheme, const std::string& steps) {
    return std::abs(values(command(text, {"solve", "--scheme", scheme, "--steps", steps, "--at", "5"}))[1] -
                    reference);
  };
  for (const auto& [scheme, rate] : {std::pair{"bdf2", 2.0}, {"grunwald_letnikov", 1.0}})
    EXPECT_NEAR(std::log2(error(scheme, "512") / error(scheme, "1024")), rate, 0.05) << scheme;
}

TEST(TransferFunctions, AreColumnsOfEventsAndEnergies) {
  const auto text =
      plant("(1 + s^0.3)/(s^0.9 + 1)") + "[event.half]\nzero = \"y - 0.5\"\n[energy]\nvalue = \"y^2\"\n";
  const auto answer =
      command(text, {"solve", "--scheme", "spectral_collocation", "--accuracy", "1e-9", "--events"});
  EXPECT_THAT(answer.out, StartsWith("event,t,y,energy\nhalf,"));
  EXPECT_THAT(answer.out, HasSubstr(",0.25"));
}

TEST(TransferFunctions, AreRefusedAtTheirPlace) {
  const auto refusal = [](std::string_view transfer) {
    const auto answer = command(plant(transfer), {"exact", "--at", "1"});
    EXPECT_EQ(answer.code, 2) << transfer;
    return answer.err.substr(answer.err.find("line"));
  };
  EXPECT_THAT(refusal("s/(1 + s)"),
              StartsWith("line 3, column 13: transfer: its highest order below the line, 1, "
                         "must be above that over it, 1"));
  EXPECT_THAT(refusal("1/(s - s)"), HasSubstr("transfer: is divided by 0"));
  EXPECT_THAT(refusal("0/(s + 1)"), HasSubstr("transfer: is 0: must be another function"));
  EXPECT_THAT(refusal("exp(-s)/(s + 1)"), HasSubstr("must be a quotient of sums of powers of s"));
  EXPECT_THAT(refusal("1/(s + 1)^0.5"), HasSubstr("a power of a sum must have a whole exponent"));
  EXPECT_THAT(refusal("1/(s + y)"), StartsWith("line 3, column 20: y: no such name here; there are s, pi"));
  EXPECT_THAT(refusal("1/(1 + s)^11"), HasSubstr("order = 11: must be a number in [0, 10]"));
  const auto with = [](const std::string& more) {
    return command(plant("1/(s + 1)") + more, {"exact", "--at", "1"}).err;
  };
  EXPECT_THAT(with("initial = [0]\n"), HasSubstr("unknown y with transfer"));
  EXPECT_THAT(with("[exact]\ny = \"1 - exp(-t)\"\n"),
              HasSubstr("must not be given with a transfer function"));
  EXPECT_THAT(with("[parameters]\ns = 1\n"), HasSubstr("parameter s: must be another name"));
}

}  // namespace
}  // namespace fde::bench
