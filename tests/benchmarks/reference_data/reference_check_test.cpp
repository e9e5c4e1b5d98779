// SPDX-License-Identifier: MIT
// Checks of tables of other programs, with a few digits, without bounds and descriptions: correct values
// pass, a wrong last digit is found and named.

#include "fdebench/benchmarks/reference_data/reference_check.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::Contains;

std::vector<TableCheck> check(const TemporaryFolder& folder) {
  return check_folder(folder.path(), 1, [](std::size_t, std::size_t, const std::string&) {}).tables;
}

TableCheck verdict_of(const std::string& file, const std::string& text) {
  const TemporaryFolder folder;
  folder.write(file, text);
  return check(folder).at(0);
}

// E_{1/2}(-1) = e erfc(1) and E_1(1) = e, E_2(-1) = cos 1, by mpmath.
constexpr auto known_values =
    "alpha,beta,re_z,im_z,re,im\n"
    "0.5,1,-1,0,0.427583576156,0\n"
    "1,1,1,0,2.71828182846,0\n"
    "2,1,-1,0,0.540302305868,0\n";

TEST(ReferenceCheck, TwelveRightDigitsHold) {
  const auto verdict = verdict_of("mine.csv", known_values);
  EXPECT_EQ(verdict.table, "mine.csv");
  EXPECT_EQ(verdict.rows, 3U);
  EXPECT_EQ(verdict.recomputed, 3U);
  EXPECT_EQ(verdict.wrong, 0U);
  EXPECT_THAT(verdict.assumptions, Contains(HasSubstr("bound")));
  EXPECT_THAT(verdict.assumptions, Contains(HasSubstr("checksum")));
  EXPECT_THAT(verdict.assumptions, Contains(HasSubstr("description")));
}

TEST(ReferenceCheck, AWrongLastDigitIsNamed) {
  std::string text = known_values;
  text.replace(text.find("2.71828182846"), 13, "2.71828182847");
  const auto verdict = verdict_of("mine.csv", text);
  EXPECT_EQ(verdict.wrong, 1U);
  EXPECT_EQ(verdict.worst_line, 3U);
  EXPECT_EQ(verdict.worst.column, "re");
  EXPECT_GT(verdict.worst.ratio, 1.0);
  EXPECT_THAT(verdict.worst_row, HasSubstr("re=2.71828182847"));
}

// e rounded to a number of digits, and with one unit more in the last place.
class Digits : public testing::TestWithParam<int> {};

TEST_P(Digits, RoundedToThemHoldsAndOneUnitMoreDoesNot) {
  const std::string e = "2.71828182845904523536028747135266249775724709369995957496696762772407663";
  const auto row = [](const std::string& value) { return "alpha,beta,re_z,re\n1,1,1," + value + "\n"; };
  std::string rounded = e.substr(0, static_cast<std::size_t>(GetParam()) + 1);
  if (e[rounded.size()] >= '5') ++rounded.back();  // no 9 is rounded up at these lengths
  std::string wrong = rounded;
  wrong.back() = static_cast<char>(wrong.back() == '9' ? '7' : wrong.back() + 1);
  EXPECT_EQ(verdict_of("e.csv", row(rounded)).wrong, 0U) << rounded;
  EXPECT_EQ(verdict_of("e.csv", row(wrong)).wrong, 1U) << wrong;
}

INSTANTIATE_TEST_SUITE_P(ReferenceCheck, Digits, testing::Values(2, 6, 12, 15, 18, 26, 40, 58));

// %.12g drops trailing zeros, as in 1 = E_{1,2}(0); the other rows of the column show the number of digits.
TEST(ReferenceCheck, AShortTextAmongLongOnesHasTheDigitsOfTheColumn) {
  const std::string rows = "alpha,beta,re_z,re\n1,1,1,2.71828182846\n1,2,0,";
  EXPECT_EQ(verdict_of("e.csv", rows + "1\n").wrong, 0U);
  EXPECT_EQ(verdict_of("e.csv", rows + "1.2\n").wrong, 1U);
  EXPECT_EQ(verdict_of("e.csv", rows + "1.0000001\n").wrong, 1U);
}

TEST(ReferenceCheck, ABoundDecidesWhereThereIsOne) {
  const std::string columns = "bound,re,re_z,beta,alpha,author\n";  // any order, and one more
  EXPECT_EQ(verdict_of("e.csv", columns + "2e-4,2.7181,1,1,1,me\n").wrong, 0U);
  EXPECT_EQ(verdict_of("e.csv", columns + "1.8e-4,2.7181,1,1,1,me\n").wrong, 1U);
  EXPECT_THAT(verdict_of("e.csv", columns + "2e-4,2.7181,1,1,1,me\n").assumptions,
              Not(Contains(HasSubstr("bound"))));
}

// Any value meets a bound that overflows a double.
TEST(ReferenceCheck, ABoundThatSaysNothingMakesItsRowWrong) {
  const auto verdict = verdict_of("e.csv", "alpha,beta,re_z,re,bound\n1,1,1,7,1e999\n1,1,1,2.7,0.02\n");
  EXPECT_EQ(verdict.wrong, 1U);
  EXPECT_EQ(verdict.worst_line, 2U);
  EXPECT_THAT(verdict.worst.failure, HasSubstr("a bound of 1e999 says nothing of a value"));
  EXPECT_THROW(verdict_of("e.csv", "alpha,beta,re_z,re,bound\n1,1,1,7,inf\n"), InvalidTable);
}

// The double nearest to e, as %.17g and as the shortest text that rounds to it, in a column of 17 digits; and
// its neighbours.
TEST(ReferenceCheck, SeventeenDigitsAreADouble) {
  const std::string rows = "alpha,beta,re_z,re\n1,1,2,7.3890560989306504\n1,1,1,";
  for (const auto* text : {"2.7182818284590451", "2.718281828459045"})
    EXPECT_EQ(verdict_of("e.csv", rows + text + "\n").wrong, 0U) << text;
  for (const auto* text : {"2.7182818284590446", "2.7182818284590455"})
    EXPECT_EQ(verdict_of("e.csv", rows + text + "\n").wrong, 1U) << text;
}

// t^2 at t = 3 is 9; with p = 3 it is 27.
TEST(ReferenceCheck, ATrajectoryHasTheParametersOfItsDescriptionOrTheDefaults) {
  const TemporaryFolder folder;
  folder.write("power.csv", "y,t\n9.000,3\n");
  EXPECT_EQ(check(folder).at(0).wrong, 0U);
  folder.write("power.json", R"({"parameters": {"p": 3}})");
  EXPECT_EQ(check(folder).at(0).wrong, 1U);
  folder.write("power.csv", "y,t\n27.00,3\n");
  EXPECT_EQ(check(folder).at(0).wrong, 0U);
  EXPECT_THAT(check(folder).at(0).assumptions, Not(Contains(HasSubstr("description"))));
}

TEST(ReferenceCheck, ANonlinearTrajectoryIsRecomputed) {
  EXPECT_EQ(verdict_of("pendulum.csv", "t,phi\n0,1\n20,0.0524981283\n").wrong, 0U);
  EXPECT_EQ(verdict_of("pendulum.csv", "t,phi\n0,1\n20,0.0524981284\n").wrong, 1U);
}

TEST(ReferenceCheck, AConvergenceTableIsRecomputed) {
  const Scene scene = scene_of("relaxation");
  MemoizedReference reference(scene);
  const double error = *examine({}, scene, reference, *find_scheme("l1"), {64})["error_end"];
  const auto table = [](double e) { return fmt::format("scheme,steps,error_end\nl1,64,{:.7g}\n", e); };
  EXPECT_EQ(verdict_of("relaxation.csv", table(error)).wrong, 0U);
  EXPECT_EQ(verdict_of("relaxation.csv", table(error * (1 + 1e-5))).wrong, 1U);
}

// adams_pc does not reach the end of the Brusselator with 64 steps: no error in the table can be right.
TEST(ReferenceCheck, AnErrorOfARunThatFailsDoesNotHold) {
  const auto verdict = verdict_of("brusselator.csv", "scheme,steps,error_end\nadams_pc,64,0.1\n");
  EXPECT_EQ(verdict.wrong, 1U);
  EXPECT_THAT(verdict.worst.failure, HasSubstr("not finite"));
}

// The first term 1/Gamma(-2000.25) is above 1e5000, so the value cannot be 12345.6789.
TEST(ReferenceCheck, AFarBetaCertifiesNothingAndTheOthersAreChecked) {
  const auto verdict = verdict_of(
      "mine.csv", "alpha,beta,re_z,im_z,re\n1,1,0,0,1.00000000\n0.5,-2000.25,-1,0,12345.6789\n1,1,0,0,1\n");
  EXPECT_EQ(verdict.wrong, 1U);
  EXPECT_EQ(verdict.recomputed, 3U);
  EXPECT_EQ(verdict.worst_line, 3U);
}

// With these parameters the solution overflows: its rows are wrong, and the check continues with other
// tables.
TEST(ReferenceCheck, ASceneWithoutAReferenceMakesItsRowsWrong) {
  const TemporaryFolder folder;
  folder.write("brusselator.csv", "t,x\n0,1\n20,1\n");
  folder.write("brusselator.json", R"({"parameters": {"A": 1e9, "B": -1e9}})");
  folder.write("power.csv", "t,y\n3,9.000\n");
  const auto verdicts = check(folder);
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].wrong, 2U);
  EXPECT_NE(verdicts[0].worst.failure, "");
  EXPECT_EQ(verdicts[1].wrong, 0U);
}

TEST(ReferenceCheck, ARowWithoutAValueIsWrongAndTheOthersAreChecked) {
  const auto verdict = verdict_of("e.csv", "alpha,beta,re_z,re\n5,1,1e300,1\n1,1,0,1\n");
  EXPECT_EQ(verdict.wrong, 1U);
  EXPECT_EQ(verdict.recomputed, 2U);
  EXPECT_EQ(verdict.worst_line, 2U);
  EXPECT_THAT(verdict.worst.failure, HasSubstr("beyond all exponents"));
}

}  // namespace
}  // namespace fde::bench
