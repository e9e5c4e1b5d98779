// SPDX-License-Identifier: MIT
// fdebench mittag-leffler: its output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>

#include "support/command_line_result.hpp"

namespace fde::bench {
namespace {

TEST(MittagLeffler, PrintsValueAndBound) {
  std::istringstream words(fdebench("mittag-leffler 1 1 -1").out);
  double re = 0.0, im = 1.0, bound = 1.0;
  words >> re >> im >> bound;
  EXPECT_NEAR(re, std::exp(-1.0), 1e-16);
  EXPECT_EQ(im, 0.0);
  EXPECT_LT(bound, 1e-15);
  EXPECT_THAT(fdebench("mittag-leffler 2 1 0,1").out, HasSubstr(" 0.4"));
  EXPECT_THAT(fdebench("mittag-leffler 0.5 1 -1 --digits 30").out,
              StartsWith("0.42758357615580700441075034449"));
}

// e^2 and E^(-1)_{1,1}(z) = 1 - z.
TEST(MittagLeffler, TakesDerivativesAndAThirdParameter) {
  EXPECT_THAT(fdebench("mittag-leffler 1 1 2 --derivative 3 --digits 20").out,
              StartsWith("7.3890560989306502272 0 "));
  EXPECT_THAT(fdebench("mittag-leffler 1 1 2,1 --gamma -1").out, StartsWith("-1 -1 "));
  EXPECT_THAT(fdebench("mittag-leffler 2 1 -1e13 --derivative 1").out,
              StartsWith("1.0899075849891"));  // sin(w) / (2 w), w^2 = 1e13
  EXPECT_THAT(fdebench("mittag-leffler 2 1 -1e13 --gamma 1.5").out,
              StartsWith("35.2565169827382"));  // 1F2(3/2; 1/2, 1; z/4), by mpmath 1.2.1
  EXPECT_EQ(fdebench("mittag-leffler 2 1 -1e19 --gamma 1.5").code, 3);
}

// A nilpotent matrix, (e^z - 1) / z, and cosh of a square root of -i.
TEST(MittagLeffler, PrintsAMatrixEntryByEntry) {
  EXPECT_THAT(
      fdebench("mittag-leffler 1 1 --matrix 0,1;0,0 --digits 9").out,
      testing::ContainsRegex(
          "^1 1 1.00000000 0 [^\n]*\n1 2 1.00000000 0 [^\n]*\n2 1 0 0 [^\n]*\n2 2 1.00000000 0 [^\n]*\n$"));
  EXPECT_THAT(fdebench("mittag-leffler 1 2 --matrix -2.5e+0-1e-3i").out, StartsWith("1 1 0.3671659713544"));
  EXPECT_THAT(fdebench("mittag-leffler 2 1 --matrix -i --digits 5").out,
              testing::MatchesRegex("1 1 0.95836 -0.49861 .*\n"));
}

struct Printed {
  std::string what, re, im, bound;
};

Printed printed(const std::string& words) {
  std::istringstream line(fdebench("mittag-leffler " + words).out);
  Printed read{.what = words, .re = {}, .im = {}, .bound = {}};
  line >> read.re >> read.im >> read.bound;
  return read;
}

// Compares in long double, whose rounding of the digits of `exact` is far below a bound for doubles.
void expect_within_bound(const Printed& value, const std::string& exact_re, const std::string& exact_im) {
  const long double re = std::stold(value.re) - std::stold(exact_re),
                    im = std::stold(value.im) - std::stold(exact_im);
  EXPECT_LE(std::abs(re), std::stold(value.bound)) << value.what;
  EXPECT_LE(std::abs(im), std::stold(value.bound)) << value.what;
  EXPECT_LE(std::stold(value.bound),
            4e-16L * (std::abs(std::stold(exact_re)) + std::abs(std::stold(exact_im))))
      << value.what;
}

// Arguments are the decimals as typed; values by mpmath with 60 digits. The values at the nearest doubles
// differ by the condition number times 1e-16: for e^700.1 by 180 times the bound.
TEST(MittagLeffler, TakesDecimalsAtTheirWord) {
  expect_within_bound(printed("1 1 700.1"), "1.12089977107323542639748742623e+304", "0.0");
  expect_within_bound(printed("0.3 1 -3.3"), "0.195844229563348205878287964199", "0.0");
  expect_within_bound(printed("0.7 1.1 2.3,0.9"), "-6.55944667640834927165518564398",
                      "28.1636004090959717548984555756");
  expect_within_bound(printed("2.5 0.1 1234567.8"), "3.00947079881241261399217114704e+120", "0.0");
  expect_within_bound(printed("2 1 -98765432.1"), "-0.341450363409071092634583446948", "0.0");
  expect_within_bound(printed("0.7 1.1 -2.3 --derivative 3"), "0.0743048999955421674371457783273", "0.0");
  expect_within_bound(printed("0.7 1.1 -2.3 --gamma 0.9"), "0.266404770432936233381939334348", "0.0");
  expect_within_bound(printed("1 1 300.3 --gamma 1"), "2.62200137768451584865814656789e+130", "0.0");
}

// e^A = e^0.1 (1 b; 0 1) for A = (0.1 b; 0 0.1), b = 700.1, by mpmath.
TEST(MittagLeffler, TakesTheEntriesOfAMatrixAtTheirWord) {
  std::istringstream lines(fdebench("mittag-leffler 1 1 --matrix 0.1,700.1;0,0.1").out);
  std::string row, column;
  for (const auto* exact : {"1.10517091807564762481170782649", "773.730159744760902130676649326", "0",
                            "1.10517091807564762481170782649"}) {
    Printed read{.what = exact, .re = {}, .im = {}, .bound = {}};
    lines >> row >> column >> read.re >> read.im >> read.bound;
    if (std::string(exact) != "0") expect_within_bound(read, exact, "0");
  }
}

// Arguments beyond the range of double: E_{1/2}(x) = 1 + 2 x / sqrt(pi) + ..., and ~ -1/(x sqrt(pi)) for x ->
// -inf.
TEST(MittagLeffler, TakesArgumentsBeyondDouble) {
  EXPECT_THAT(fdebench("mittag-leffler 0.5 1 1e-400").out, StartsWith("1 0 "));
  EXPECT_THAT(fdebench("mittag-leffler 0.5 1 -1e400").out, StartsWith("0 0 "));
  EXPECT_EQ(fdebench("mittag-leffler 1 1 1e400").code, 3);
}

// E_{alpha,beta}(0) = 1/Gamma(beta): the first and the last of 2500 digits, by mpmath.
TEST(MittagLeffler, IsTheReciprocalGammaAtZeroToThousandsOfDigits) {
  struct Ends {
    std::string beta, first, last;
  };
  for (const auto& [beta, first, last] :
       {Ends{"0.3", "0.33427275256419055397", "17106519665313632316 0 "},
        Ends{"-2.7", "-1.0740183539887442499288", "78646324768465270063 0 "},
        Ends{"7.3", "0.00078651990848892938", "31701338256883493205 0 "}}) {
    const auto answer = fdebench("mittag-leffler 0.5 " + beta + " 0 --digits 2500");
    EXPECT_THAT(answer.out, AllOf(StartsWith(first), HasSubstr(last)));
  }
}

TEST(MittagLeffler, EndsWithItsBudget) {
  for (const std::string words :
       {"0.5 1 -1 --digits 20000", "0.5 0.3 0 --digits 50000", "0.7 1 0.1 --gamma 0.3 --digits 10000",
        "1 0.5 -3 --gamma 0.3 --digits 5000", "0.7 1 -3 --derivative 2 --digits 5000",
        "0.7 1 --matrix 0.1,2;3,-4 --digits 3000"}) {
    const auto start = std::chrono::steady_clock::now();
    const auto answer = fdebench("mittag-leffler " + words + " --budget 0.1");
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(answer.code, 3) << words;
    EXPECT_EQ(answer.out, "") << words;
    EXPECT_EQ(answer.err, "fdebench: the budget of 0.1 s ran out before the value was known\n") << words;
    EXPECT_LT(elapsed.count(), 3.0) << words;
  }
  EXPECT_EQ(fdebench("mittag-leffler 0.5 1 -1 --budget 60").code, 0);
}

TEST(MittagLeffler, TakesComplexNumbersInBothNotations) {
  EXPECT_EQ(fdebench("mittag-leffler 0.5 1 -5+2i").out, fdebench("mittag-leffler 0.5 1 -5,2").out);
  EXPECT_EQ(fdebench("mittag-leffler 0.5 1 2e-1-1e-1i").out, fdebench("mittag-leffler 0.5 1 0.2,-0.1").out);
}

}  // namespace
}  // namespace fde::bench
