// `fdebench geometry`: its output and its refusals.

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/number_text.hpp"
#include "support/answer_of.hpp"

namespace fde {
namespace {

// The value in the line with this beginning.
double value_of(const std::string& text, const std::string& beginning) {
  const auto at = text.find("\n" + beginning + ",");
  if (at == std::string::npos) return std::nan("");
  const auto from = at + beginning.size() + 2;
  return *number_in(text.substr(from, text.find('\n', from) - from));
}

// On the unit sphere Gamma^theta_phi,phi = -sin cos and Gamma^phi_theta,phi = cot.
TEST(GeometryCommand, PrintsTheSymbolsOfTheSphere) {
  const auto answer = fdebench({"geometry", "loxodrome", "--place", "0.7,0", "--velocity", "0.3,0.2"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_EQ(answer.out.substr(0, 21), "quantity,i,j,k,value\n");
  const double s = std::sin(0.7), c = std::cos(0.7);
  EXPECT_NEAR(value_of(answer.out, "metric,phi,phi,"), s * s, 1e-15);
  EXPECT_NEAR(value_of(answer.out, "christoffel,theta,phi,phi"), -s * c, 1e-15);
  EXPECT_NEAR(value_of(answer.out, "christoffel,phi,theta,phi"), c / s, 1e-15);
  EXPECT_NEAR(value_of(answer.out, "connection,theta,phi,"), -s * c * 0.2, 1e-15);
  EXPECT_NEAR(value_of(answer.out, "semispray,theta,,"), -s * c * 0.04, 1e-15);
  EXPECT_NEAR(value_of(answer.out, "semispray,phi,,"), 2.0 * c / s * 0.06, 1e-15);
}

// From rest the blade slides along its edge: no reaction, x'' = g sin(theta), and the semispray is 2G* =
// -x''.
TEST(GeometryCommand, TakesTheStartOfTheSceneWhereNoStateIsGiven) {
  const auto answer = fdebench({"geometry", "knife_edge", "--set", "theta=0.3"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_EQ(value_of(answer.out, "multiplier,1,,"), 0.0);
  EXPECT_NEAR(value_of(answer.out, "constrained_semispray,x,,"), -9.81 * std::sin(0.3), 1e-15);
}

// With a memory term the reaction is not a function of the state.
TEST(GeometryCommand, LeavesTheReactionOutWhereItRemembers) {
  const auto answer = fdebench({"geometry", "fractional_knife_edge"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_NE(answer.out.find("semispray,"), std::string::npos);
  EXPECT_EQ(answer.out.find("constrained_semispray"), std::string::npos);
}

// The default, the acceleration formulation, does not exist for alpha >= 1/2.
TEST(GeometryCommand, DoesNotDependOnTheFormulation) {
  EXPECT_EQ(fdebench({"geometry", "fractional_constraint_nonlinear", "--set", "alpha=0.7"}).code, 0);
}

TEST(GeometryCommand, RefusesWhatHasNoGeometry) {
  EXPECT_EQ(fdebench({"geometry", "relaxation"}).code, 2);
  const auto answer = fdebench({"geometry", "loxodrome", "--place", "1,2,3"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_NE(answer.err.find("--place = 1,2,3: must be 2 numbers, one a coordinate"), std::string::npos);
  EXPECT_EQ(fdebench({"geometry", "loxodrome", "--place", "0,0"}).code, 3);
}

}  // namespace
}  // namespace fde
