// SPDX-License-Identifier: MIT
// `fdebench poles` and `fdebench response` against zeros and transfer functions in closed form.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/equation_files/file_commands.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;

struct Pole {
  double re, im, multiplicity;
};

std::vector<Pole> poles_in(const CommandOutput& answer) {
  std::vector<Pole> all;
  std::size_t line = answer.out.find('\n') + 1;
  EXPECT_EQ(answer.out.substr(0, line), "re,im,multiplicity\n");
  for (; line < answer.out.size(); line = answer.out.find('\n', line) + 1) {
    Pole& pole = all.emplace_back();
    EXPECT_EQ(std::sscanf(answer.out.c_str() + line, "%lf,%lf,%lf", &pole.re, &pole.im, &pole.multiplicity),
              3);
  }
  return all;
}

std::string linear_file(std::string_view terms, std::string_view rhs, std::string_view initial) {
  return fmt::format("end = 1\n[unknown.x]\nterms = [{}]\nrhs = \"{}\"\ninitial = [{}]\n", terms, rhs,
                     initial);
}

void expect_poles(const CommandOutput& answer, const std::vector<Pole>& known) {
  const auto found = poles_in(answer);
  ASSERT_EQ(found.size(), known.size()) << answer.out;
  for (std::size_t k = 0; k < known.size(); ++k) {
    const double rounding = known[k].multiplicity > 1 ? 1e-10 : 1e-14;
    EXPECT_NEAR(found[k].re, known[k].re, rounding);
    EXPECT_NEAR(found[k].im, known[k].im, rounding);
    EXPECT_EQ(found[k].multiplicity, known[k].multiplicity);
  }
}

TEST(Poles, AreTheZerosOfTheCharacteristicFunction) {
  const double root = std::sqrt(3.0) / 2.0;
  expect_poles(command(linear_file("[1, 2], [1, 1]", "-x", "1, 0"), {"poles"}),
               {{-0.5, root, 1}, {-0.5, -root, 1}});
  expect_poles(command(linear_file("[1, 1]", "-2*x", "1"), {"poles"}), {{-2.0, 0.0, 1}});  // on the cut
  expect_poles(command(linear_file("[1, 2], [2, 1]", "-x", "1, 0"), {"poles"}), {{-1.0, 0.0, 2}});
  // s^1.5 = -1: s = e^(2 pi i / 3) and its conjugate. s^0.5 = -1 has no zero on the principal sheet.
  expect_poles(command(linear_file("[1, 1.5]", "-x", "1, 0"), {"poles"}),
               {{-0.5, root, 1}, {-0.5, -root, 1}});
  expect_poles(command(linear_file("[1, 0.5]", "-x", "1"), {"poles"}), {});
}

// They are those of the linear part, whatever the loads, the values at the end and the constraints.
TEST(Poles, DoNotDependOnLoads) {
  const double root = std::sqrt(3.0) / 2.0;
  const std::vector<Pole> known{{-0.5, root, 1}, {-0.5, -root, 1}};
  expect_poles(command(linear_file("[1, 2], [1, 1]", "sin(t)/(1 + t) - x", "1, 0"), {"poles"}), known);
  expect_poles(command(linear_file("[1, 2], [1, 1]", "-x", "1") + "final = [0]\n", {"poles"}), known);
  const auto multiplier = linear_file("[1, 2], [1, 1]", "p + exp(-t)", "1, 0") +
                          "[unknown.p]\norder = 0\nrhs = \"p + x\"\ninitial = [-1]\n";
  expect_poles(command(multiplier, {"poles"}), known);
}

// D^g x = lambda x is stable if and only if |arg lambda| > g pi/2 (Matignon 1996): a rotation by pi/4 is on
// the edge for g = 1/2.
TEST(Poles, DecideStability) {
  const auto rotation = [](std::string_view order) {
    return fmt::format(
        "end = 1\n[unknown.x]\norder = {0}\nrhs = \"x - y\"\ninitial = [1]\n"
        "[unknown.y]\norder = {0}\nrhs = \"x + y\"\ninitial = [0]\n",
        order);
  };
  EXPECT_THAT(command(rotation("0.499"), {"poles"}).err,
              HasSubstr("stable: no pole with a real part of 0 or above"));
  EXPECT_THAT(command(rotation("0.5"), {"poles"}).err, HasSubstr("on the imaginary axis"));
  EXPECT_THAT(command(rotation("0.501"), {"poles"}).err,
              HasSubstr("unstable: poles with a positive real part"));
  // s^0.5 (s^1.5 + 1): what does not decay is a constant.
  EXPECT_THAT(command(linear_file("[1, 2], [1, 0.5]", "0", "1, 0"), {"poles"}).err,
              HasSubstr("on the imaginary axis"));
  EXPECT_EQ(command(linear_file("[1, 0.5]", "-x", "1"), {"poles", "--quiet"}).err, "");
}

TEST(Poles, OfNonlinearEquationsAreRefused) {
  const auto answer = command(linear_file("[1, 0.5]", "-x^2", "1"), {"poles"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("must be linear with constant coefficients"));
}

// 1/(s^0.5 + 1) at s = i.
TEST(Responses, AreTransferFunctionsOnTheImaginaryAxis) {
  const std::string plant = "end = 1\n[unknown.y]\ntransfer = \"1/(s^0.5 + 1)\"\ninput = \"1\"\n";
  const auto answer = command(plant, {"response", "--frequencies", "1"});
  EXPECT_EQ(answer.out.substr(0, answer.out.find('\n')), "frequency,magnitude_y,phase_y");
  const auto row = values(answer);
  const std::complex<double> known = 1.0 / (std::polar(1.0, std::acos(-1.0) / 4.0) + 1.0);
  EXPECT_NEAR(row[1], std::abs(known), 1e-15);
  EXPECT_NEAR(row[2], -22.5, 1e-13);
  EXPECT_EQ(command(plant, {"response", "--frequencies", "0"}).code, 2);
  EXPECT_THAT(fdebench({"response", "relaxation", "--frequencies", "1"}).err,
              HasSubstr("must be one with a transfer function"));
}

// Under sin(2 t) the solution of a stable plant tends to |G| sin(2 t + arg G).
TEST(Responses, AreWhatSinusoidalInputsLeave) {
  const std::string plant =
      "end = 400\n[unknown.y]\ntransfer = \"(2*s^0.5 + 1)/(s^2.2 + 0.9*s^1.1 + 1)\"\ninput = \"sin(2*t)\"\n";
  const auto response = values(command(plant, {"response", "--frequencies", "2"}));
  const double known = response[1] * std::sin(2.0 * 400.0 + response[2] * std::acos(-1.0) / 180.0);
  EXPECT_NEAR(values(command(plant, {"solve", "--scheme", "bdf2", "--steps", "65536", "--at", "400"}))[1],
              known, 1e-3);
}

}  // namespace
}  // namespace fde::bench
