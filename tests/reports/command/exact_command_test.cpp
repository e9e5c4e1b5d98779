// SPDX-License-Identifier: MIT
// `fdebench exact`: columns, bounds, digits, budget.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/command_line_result.hpp"

namespace fde::bench {
namespace {

TEST(Exact, PrintsTheColumnsAndABound) {
  const auto answer = fdebench("exact relaxation --at 0,1");
  EXPECT_THAT(answer.out, StartsWith("t,y,bound\n0,1,"));
  EXPECT_NEAR(csv_rows(answer.out)[1][1], 0.427583576155807, 1e-15);
  EXPECT_LT(csv_rows(answer.out)[1][2], 1e-15);
}

// At t = 1e20 the angular velocity is exact, but the position after so many turns is not known.
TEST(Exact, PrintsTheBoundOfEachColumn) {
  for (const std::string digits : {"", " --digits 30"}) {
    const auto answer = fdebench("exact knife_edge --at 1e20 --bounds" + digits);
    EXPECT_THAT(answer.out, HasSubstr("bound,bound_x,bound_y"));
    const auto plain = csv_rows(fdebench("exact knife_edge --at 1e20" + digits).out)[0],
               row = csv_rows(answer.out)[0];
    for (std::size_t c = 0; c < plain.size(); ++c) EXPECT_EQ(row[c], plain[c]) << c;
    const auto bounds = std::vector<double>(row.begin() + std::ssize(plain), row.end());
    EXPECT_EQ(std::ranges::max(bounds), plain.back());
    EXPECT_LT(bounds.back(), 1e-15);
  }
}

TEST(Exact, OfANonlinearSceneIsTheReferenceWithItsEstimate) {
  const auto answer = fdebench("exact pendulum --at 5");
  EXPECT_THAT(answer.out, StartsWith("t,phi,Dbeta_phi,dphi,Dalpha_phi,energy,bound\n"));
  EXPECT_LT(csv_rows(answer.out)[0][6], 1e-10);
  EXPECT_NEAR(csv_rows(answer.out)[0][1], 0.26091, 1e-4);
}

TEST(Exact, TellsTheReactions) {
  const auto answer = fdebench("exact knife_edge --at 1 --set theta=0.5");
  EXPECT_THAT(answer.out, StartsWith("t,x,y,phi,dx,dy,dphi,energy,constraint,lambda,power,bound\n"));
  EXPECT_NEAR(csv_rows(answer.out)[0][9], -2.0 * 9.81 * std::sin(0.5) * std::sin(1.0), 1e-14);
  EXPECT_THAT(fdebench("exact fractional_knife_edge --at 1").out, Not(HasSubstr("lambda")));
}

// The reference exists although the default formulation refuses this scene, where a.b = 0.
TEST(Exact, DoesNotDependOnTheFormulation) {
  const std::string scene =
      "exact fractional_constraint_2d --at 3 --set alpha=1.5 --set b1=0.6 --set b2=-0.3";
  EXPECT_EQ(fdebench(scene).code, 0);
  EXPECT_EQ(fdebench(scene).out, fdebench(scene + " --set formulation=multiplier").out);
}

// e erfc(1), the first 50 digits by mpmath.
TEST(Exact, GivesAnyNumberOfDigits) {
  EXPECT_THAT(fdebench("exact relaxation --at 1 --digits 50").out,
              HasSubstr("0.42758357615580700441075034449051518082015950316"));
}

TEST(Exact, SortsTimesAndTakesEachOnceAsSolveDoes) {
  for (const std::string digits : {"", " --digits 20"}) {
    const auto sorted = fdebench("exact relaxation --at 0,1,2" + digits);
    EXPECT_EQ(fdebench("exact relaxation --at 2,0,1,2" + digits).out, sorted.out);
  }
  const auto solved = fdebench("solve relaxation --scheme l1 --steps 4 --until 2 --at 2,0,1,2").out;
  EXPECT_EQ(csv_rows(solved).size(), 3U);
}

// Coefficients such as nu tau^beta are computed at the requested precision. Values by mpmath's Talbot
// inversion with 60 digits.
TEST(Exact, TakesDecimalsAtTheirWord) {
  EXPECT_THAT(fdebench("exact damped_oscillator --at 1 --digits 40").out,
              HasSubstr("0.33194262273616016761353451367782687069"));
  EXPECT_THAT(fdebench("exact diethelm --at 3 --set gamma=0.123456789012345 --digits 19").out,
              HasSubstr("6303.526028522351357"));
}

TEST(Exact, OfATwoSidedSceneIsWhatTwoMethodsAgreeOn) {
  EXPECT_EQ(printed(fdebench("exact fractional_extremum --set k=1 --at 0.5")).substr(0, 10), "t,y,bound\n");
}

TEST(Exact, BeyondDoubleIsANumericalFailure) {
  EXPECT_THAT(fdebench("exact relaxation --set lambda=10 --at 50"),
              fails_with(3, "fdebench: the exact solution is beyond double at t = 50\n"));
}

// y = (1 - t) sqrt(t) solves the equation with exp(t (1 - t)^2 - y^2), which magnifies a small error of y
// without limit: up to t = 5 the two methods differ by far more than all values.
TEST(Exact, ThatIsNotKnownAtAllIsANumericalFailure) {
  const std::string file = FDE_SOURCE_DIR "/benchmarks/peers/problems/nag_abel_exponential.toml";
  EXPECT_EQ(fdebench("exact " + file + " --at 3").code, 0);
  EXPECT_THAT(fdebench("exact " + file + ":until=5 --at 5"),
              fails_with(3, HasSubstr("the two methods of a reference differ by")));
}

// Linear scenes with many digits, and a nonlinear scene.
TEST(Exact, EndsWithItsBudgetAndPrintsNothingElse) {
  for (const auto& [arguments, time] : {std::pair{"relaxation --at 1 --digits 3000", "1"},
                                        {"extensible_pendulum --at 7.125", "7.125"},
                                        {"damped_oscillator --at 2 --digits 3000", "2"}}) {
    const auto answer = fdebench(fmt::format("exact {} --budget 0.01", arguments));
    EXPECT_EQ(answer.code, 3) << arguments;
    EXPECT_EQ(answer.out, "") << arguments;
    EXPECT_EQ(answer.err,
              fmt::format("fdebench: the budget of 0.01 s ran out before the reference was known at t = {}\n",
                          time));
  }
  EXPECT_EQ(fdebench("exact relaxation --at 1 --budget 100").code, 0);
}

}  // namespace
}  // namespace fde::bench
