// SPDX-License-Identifier: MIT
// `fdebench geometry`: its output and its refusals.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/text/number_text.hpp"
#include "support/command_line_result.hpp"

namespace fde::bench {
namespace {

// The value in the line with this beginning.
double value_of(const std::string& text, const std::string& beginning) {
  const auto at = text.find("\n" + beginning + ",");
  if (at == std::string::npos) return std::nan("");
  const auto from = at + beginning.size() + 2;
  return *try_parse_number(text.substr(from, text.find('\n', from) - from));
}

// On the unit sphere Gamma^theta_phi,phi = -sin cos and Gamma^phi_theta,phi = cot.
TEST(GeometryCommand, PrintsTheSymbolsOfTheSphere) {
  const double s = std::sin(0.7), c = std::cos(0.7), turn = 0.3 / s;
  const auto answer = printed(fdebench({"geometry", "loxodrome", "--set", "k=1", "--place", "0.7,0",
                                        "--velocity", fmt::format("0.3,{}", turn)}));
  EXPECT_EQ(answer.substr(0, 21), "quantity,i,j,k,value\n");
  EXPECT_NEAR(value_of(answer, "metric,phi,phi,"), s * s, 1e-15);
  EXPECT_NEAR(value_of(answer, "christoffel,theta,phi,phi"), -s * c, 1e-15);
  EXPECT_NEAR(value_of(answer, "christoffel,phi,theta,phi"), c / s, 1e-15);
  EXPECT_NEAR(value_of(answer, "connection,theta,phi,"), -s * c * turn, 1e-15);
  EXPECT_NEAR(value_of(answer, "semispray,theta,,"), -s * c * turn * turn, 1e-15);
  EXPECT_NEAR(value_of(answer, "semispray,phi,,"), 2.0 * c / s * 0.3 * turn, 1e-15);
}

// The file of isokinetic calls its coordinates x1, x2, x3, because q1 is a parameter.
TEST(GeometryCommand, NamesCoordinatesAsTheirColumns) {
  const auto answer = fdebench("geometry isokinetic");
  EXPECT_EQ(value_of(answer.out, "metric,q2,q2,"), 1.0);
  EXPECT_EQ(value_of(answer.out, "metric,q1,q2,"), 0.0);
}

// From rest the blade slides along its edge: no reaction, x'' = g sin(theta), and the semispray is 2G* =
// -x''.
TEST(GeometryCommand, TakesTheStartOfTheSceneWhereNoStateIsGiven) {
  const auto answer = printed(fdebench({"geometry", "knife_edge", "--set", "theta=0.3"}));
  EXPECT_EQ(value_of(answer, "multiplier,1,,"), 0.0);
  EXPECT_NEAR(value_of(answer, "constrained_semispray,x,,"), -9.81 * std::sin(0.3), 1e-15);
}

// phi' sin(theta) = k theta'. The nearest velocity in the metric has theta' = (0.3 + 0.2 sin(theta))/2 for k
// = 1.
TEST(GeometryCommand, RefusesVelocitiesThatViolateTheConstraint) {
  const auto answer =
      fdebench({"geometry", "loxodrome", "--set", "k=1", "--place", "0.5,0", "--velocity", "0.3,0.2"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.out, "");
  const std::string allowed =
      "--velocity = 0.3,0.2: must be velocities that keep the constraints at this place, as ";
  const auto at = answer.err.find(allowed);
  ASSERT_NE(at, std::string::npos) << answer.err;
  const auto nearest = answer.err.substr(at + allowed.size(), answer.err.find('\n') - at - allowed.size());
  const double theta = (0.3 + 0.2 * std::sin(0.5)) / 2;
  EXPECT_NEAR(*try_parse_number(nearest.substr(0, nearest.find(','))), theta, 1e-15);
  EXPECT_NEAR(*try_parse_number(nearest.substr(nearest.find(',') + 1)), theta / std::sin(0.5), 1e-15);
  EXPECT_EQ(
      fdebench({"geometry", "loxodrome", "--set", "k=1", "--place", "0.5,0", "--velocity", nearest}).code, 0);
}

// At another place the velocity at t = 0 is brought onto the constraint there: phi' sin(theta) = k theta'.
TEST(GeometryCommand, BringsTheVelocityOfTheStartOntoTheConstraint) {
  const auto answer = printed(fdebench({"geometry", "loxodrome", "--set", "k=1", "--place", "0.5,0"}));
  const double cot = 1.0 / std::tan(0.5), turn = value_of(answer, "connection,phi,theta,") / cot,
               climb = value_of(answer, "connection,phi,phi,") / cot;
  EXPECT_GT(climb, 0.05);
  EXPECT_NEAR(turn * std::sin(0.5), climb, 1e-15);
}

// With a memory term the reaction is not a function of the state.
TEST(GeometryCommand, LeavesTheReactionOutWhereItRemembers) {
  const auto answer = printed(fdebench("geometry fractional_knife_edge"));
  EXPECT_NE(answer.find("semispray,"), std::string::npos);
  EXPECT_EQ(answer.find("constrained_semispray"), std::string::npos);
}

// The default, the acceleration formulation, does not exist for alpha >= 1/2.
TEST(GeometryCommand, DoesNotDependOnTheFormulation) {
  EXPECT_EQ(fdebench({"geometry", "fractional_constraint_nonlinear", "--set", "alpha=0.7"}).code, 0);
}

TEST(GeometryCommand, RefusesWhatHasNoGeometry) {
  EXPECT_EQ(fdebench("geometry relaxation").code, 2);
  const auto answer = fdebench({"geometry", "loxodrome", "--place", "1,2,3"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_NE(answer.err.find("--place = 1,2,3: must be 2 numbers, one a coordinate"), std::string::npos);
  EXPECT_EQ(fdebench({"geometry", "loxodrome", "--place", "0,0"}).code, 3);
}

}  // namespace
}  // namespace fde::bench
