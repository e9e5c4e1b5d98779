// SPDX-License-Identifier: MIT
// Riemann-Liouville derivatives in equation files.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/equation_files/file_commands.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string equation(std::string_view order, std::string_view rhs, std::string_view initial = "1") {
  return fmt::format(
      "end = 2\n[unknown.y]\nderivative = \"riemann-liouville\"\norder = {}\nrhs = \"{}\"\ninitial = [{}]\n",
      order, rhs, initial);
}

struct Value {
  std::string_view t;
  double y;
};

// D^0.5 y = -y, J^0.5 y(0) = 1: y = t^-0.5 E_{0.5,0.5}(-t^0.5), in 40 digits by mpmath's sums.
TEST(RiemannLiouville, RelaxesAsTheMittagLefflerFunctionOfItsKernel) {
  constexpr std::array known{Value{"0.001", 16.875946941523654819}, Value{"0.25", 0.51268882290258669903},
                             Value{"2", 0.062738277955091465086}};
  for (const auto& [t, y] : known) {
    const auto row = exact(equation("0.5", "-y"), t);
    EXPECT_NEAR(row[2], y, 1e-15 * (1.0 + y)) << t;
    EXPECT_LT(row[3], 2e-15 * (1.0 + y)) << t;
  }
}

// D^1.5 y = -y, D^0.5 y(0) = 2, J^0.5 y(0) = 3: y = 2 t^0.5 E_{1.5,1.5}(-t^1.5) + 3 t^-0.5
// E_{1.5,0.5}(-t^1.5).
TEST(RiemannLiouville, HasOneInitialValueForEachWholeOrderBelow) {
  EXPECT_NEAR(exact(equation("1.5", "-y", "2, 3"), "0.25")[2], 3.7300700806659945359, 1e-14);
}

// An order 1 is y' = -y with J^0 y(0) = y(0).
TEST(RiemannLiouville, OfOrderOneIsTheDerivative) {
  EXPECT_NEAR(exact(equation("1", "-y"), "2")[1], std::exp(-2.0), 1e-15);
}

// Initial values of 0: the derivatives of Riemann and Liouville and of Caputo are the same, for nonlinear
// equations too.
TEST(RiemannLiouville, FromZeroIsCaputos) {
  const std::string caputo = "end = 2\n[unknown.y]\norder = 0.7\nrhs = \"1 - y^3\"\ninitial = [0]\n";
  const std::vector<std::string> solve{"solve", "--scheme", "bdf2", "--steps", "64", "--at", "2"};
  EXPECT_EQ(values(command(equation("0.7", "1 - y^3", "0"), solve)), values(command(caputo, solve)));
}

// D^0.3 y = z - y, J^0.7 y(0) = 1 beside the Caputo derivative D^0.8 z = y/2 - z, z(0) = 1, whose right-hand
// side is infinite at 0 as y is. Inverse Laplace transforms by mpmath (Talbot's method of degree 60).
TEST(RiemannLiouville, DrivesUnknownsWithCaputoDerivatives) {
  const auto pair = equation("0.3", "z - y") + "[unknown.z]\norder = 0.8\nrhs = \"y/2 - z\"\ninitial = [1]\n";
  const auto early = exact(pair, "0.25"), late = exact(pair, "2");
  EXPECT_NEAR(early[3], 0.73942024610603095153, 1e-14);
  EXPECT_NEAR(early[2], 0.95690286586789547367, 1e-14);
  EXPECT_NEAR(late[3], 0.30607794282315129693, 1e-14);
  EXPECT_NEAR(late[2], 0.39310472924533922256, 1e-14);
}

// D^0.5 y = -y, J^0.5 y(0) = 1, drives 2 D^0.8 z = y - z, z(0) = 0; and D^1.5 y = -y, D^0.5 y(0) = 1, J^0.5
// y(0) = 0, drives 2 D^1.5 w + D^0.5 w = y - w, w(0) = w'(0) = 0. Inverse Laplace transforms, by mpmath, of
// 1/((s^0.5 + 1) (2 s^0.8 + 1)) and 1/((s^1.5 + 1) (2 s^1.5 + s^0.5 + 1)). Of several terms there are no
// powers to take where y is infinite.
TEST(RiemannLiouville, DrivesEquationsWithCoefficients) {
  const std::string two_terms =
                        "[unknown.w]\nterms = [[2, 1.5], [1, 0.5]]\nrhs = \"y - w\"\ninitial = [0, 0]\n",
                    one_term = "[unknown.z]\nterms = [[2, 0.8]]\nrhs = \"y - z\"\ninitial = [0]\n";
  EXPECT_NEAR(exact(equation("0.5", "-y") + one_term, "0.5")[2], 0.19820274411373318251, 1e-14);
  EXPECT_NEAR(exact(equation("1.5", "-y", "1, 0") + two_terms, "0.5")[2], 0.052510176656891097008, 1e-14);
  EXPECT_THAT(command(equation("0.5", "-y") + two_terms, {"exact", "--at", "0.5"}).err,
              HasSubstr("unknown w: must have one order above 0"));
}

// What remains for the schemes starts like t^(1 + a) or more, whatever the order is: bdf2 has its rate 2,
// L1 2 - a, Gruenwald-Letnikov 1.
TEST(RiemannLiouville, LeavesASmoothProblemToTheSchemes) {
  const auto text = equation("0.5", "2*t - y");
  for (const auto& [scheme, rate] :
       {std::pair{"bdf2", 2.0}, {"l1", 1.5}, {"grunwald_letnikov", 1.0}, {"product_trapezoidal", 2.0}}) {
    const double coarse = error_at_end(text, "2", scheme, "512"),
                 fine = error_at_end(text, "2", scheme, "1024");
    EXPECT_NEAR(std::log2(coarse / fine), rate, 0.07) << scheme;
  }
}

// y is infinite at 0, with the sign of its initial value; its column (t/end)^0.5 y is finite there, and at
// the end is y: with end = 2 it begins with 2^-0.5 times the initial value over Gamma(0.5).
TEST(RiemannLiouville, StartsAtInfinity) {
  const auto at = [](std::string_view t) {
    return values(command(equation("0.5", "-y", "-1"), {"solve", "--scheme", "spectral_collocation",
                                                        "--accuracy", "1e-10", "--at", std::string(t)}));
  };
  EXPECT_EQ(at("0")[2], -HUGE_VAL);
  EXPECT_NEAR(at("0")[1], -std::sqrt(0.5 / std::numbers::pi), 1e-15);
  EXPECT_NEAR(at("0.001")[2], -16.875946941523654819, 1e-8);
  EXPECT_NEAR(at("2")[2], at("2")[1], 1e-15);
}

// The column is (t/end)^0.5 y with the end of the file, also of a reference that is made for each time asked
// for.
TEST(RiemannLiouville, HasTheSameColumnForEachEnd) {
  const auto text = equation("0.5", "floor(2*t) - y");
  const auto known = exact(text, "1.25");
  const auto run = values(
      command(text, {"solve", "--scheme", "spectral_collocation", "--accuracy", "1e-10", "--at", "1.25"}));
  EXPECT_NEAR(run[1], known[1], 1e-9);
  EXPECT_NEAR(run[2], known[2], 1e-9);
}

// Terms lambda^k t^p cancel where |lambda| t^a is large: the bound says so.
TEST(RiemannLiouville, BoundsWhatCancels) {
  const auto row = exact(equation("0.25", "-5*y"), "2");
  EXPECT_NEAR(row[2], 0.0027289723516088333458, row[3]);  // t^-0.75 E_{0.25,0.25}(-5 t^0.25), by mpmath
  EXPECT_GT(row[3], 1e-13);
}

TEST(RiemannLiouville, IsRefusedAtItsPlace) {
  const auto refusal = [](const std::string& text) {
    const auto answer = command(text, {"solve", "--scheme", "l1", "--steps", "8"});
    EXPECT_EQ(answer.code, 2) << text;
    return answer.err.substr(answer.err.find("line"));
  };
  EXPECT_THAT(refusal(equation("0.5", "-y^2")),
              StartsWith("line 5, column 8: must be linear in y with constant coefficients"));
  EXPECT_THAT(refusal(equation("0.5", "-t*y")), HasSubstr("must be linear in y"));
  EXPECT_THAT(refusal(equation("0.5", "-y", "1, 2")), HasSubstr("has 2 initial values: must have 1"));
  EXPECT_THAT(refusal(equation("0.5", "-D(y, 0.2)")), HasSubstr("D(y, 0.2): must not occur"));
  EXPECT_THAT(refusal(equation("0.5", "-y(t - 1)")), HasSubstr("y(t - 1): must not occur"));
  EXPECT_THAT(refusal(equation("0.001", "-y")), HasSubstr("needs more than 200 powers of t"));
  EXPECT_THAT(refusal(equation("0.5", "-y") + "[exact]\ny = \"0\"\n"), HasSubstr("exact: must not be given"));
  EXPECT_THAT(refusal(equation("0.5", "-y") + "before = \"0\"\n"), HasSubstr("Riemann-Liouville"));
}

}  // namespace
}  // namespace fde::bench
