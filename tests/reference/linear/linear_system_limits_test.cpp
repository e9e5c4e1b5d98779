// SPDX-License-Identifier: MIT
// Linear systems at the start, with overflow in double, and with invalid input.

#include <cmath>
#include <limits>
#include <stdexcept>

#include "fdebench/schemes/problem/progress/progress.hpp"
#include "support/linear_system_testing.hpp"

namespace fde::reference {
namespace {

Matrix one_by_one(double value) { return Matrix::Constant(1, 1, value); }

TEST(LinearSystem, StartsWithItsInitialValuesAndGrowsBeyondDouble) {
  const Reference solution = linear_reference({.orders = {0.3, 1.7},
                                               .initial = {{0.1}, {-4.0, 1.0}},
                                               .matrix = (Matrix(2, 2) << 5.0, 1.0, 2.0, 3.0).finished(),
                                               .loads = {{}, {{1.0, -0.5}}}});
  EXPECT_EQ(solution.at(0.0).value, (Vec(2) << 0.1, -4.0).finished());
  EXPECT_EQ(solution.at(1e4).value[0], -std::numeric_limits<double>::infinity());
  EXPECT_GT(solution.digits(1e4, 5)[0].value.find("e+"), 0U);
  const Reference steady = linear_reference({.orders = {0.5, 1.3},
                                             .initial = {{1.0}, {2.0, 0.0}},
                                             .matrix = (Matrix(2, 2) << -2.0, 1.0, 0.25, -0.125).finished()});
  for (const double t : {0.0, 0.1, 1e6}) EXPECT_EQ(steady.at(t).value, (Vec(2) << 1.0, 2.0).finished()) << t;
}

// P = (s^g - re)^2 + im^2; for small im the zeros s* agree to all digits of long double.
LinearSystem pair(double order, double re, double im) {
  return {.orders = {order, order},
          .initial = order > 1.0 ? std::vector{std::vector{1.0, 0.0}, std::vector{0.0, 0.0}}
                                 : std::vector{std::vector{1.0}, std::vector{0.0}},
          .matrix = (Matrix(2, 2) << re, -im, im, re).finished()};
}

// s* = 1e97 e^(162 degrees i) is negligible: the value is the leading term -1 / (z Gamma(1-g)) of E_g(z),
// z = re + i im.
TEST(LinearSystem, HasNothingOfDoubleZerosFarOnTheLeft) {
  const auto [value, bound] = linear_reference(pair(1.11, -1e108, 3.0)).at(1.0);
  const double head = 1e-108 / std::tgamma(1.0 - 1.11);
  EXPECT_NEAR(value[0] / head, 1.0, 1e-14);
  EXPECT_NEAR(value[1] / (3e-108 * head), 1.0, 1e-14);
  EXPECT_LE(bound[0], 1e-15 * std::abs(head));
}

// s* = 1e33 in the right half-plane has 17 correct digits, so e^s* has none, and more digits do not help.
TEST(LinearSystem, RefusesAtOnceDoubleZerosFarOnTheRight) {
  std::size_t work = 0;
  const ProgressScope scope([&](std::size_t, std::size_t) { ++work; });
  EXPECT_THROW(linear_reference(pair(0.6, 1e20, 3e-20)).at(1.0), std::runtime_error);
  EXPECT_EQ(work, 0U);
}

struct Mistake {
  const char* name;
  LinearSystem system;
  const char* message;
};

class LinearSystemMistake : public testing::TestWithParam<Mistake> {};

TEST_P(LinearSystemMistake, IsNamed) {
  try {
    linear_reference(GetParam().system);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), std::string("linear system: ") + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    , LinearSystemMistake,
    testing::ValuesIn<Mistake>(
        {{"NoComponents", {}, "0 components: must be 1 to 12"},
         {"TooMany",
          {std::vector(13, 1.0), {13, {1.0}}, Matrix::Identity(13, 13)},
          "13 components: must be 1 to 12"},
         {"Shape",
          {{0.5}, {{1.0}}, Matrix(1, 2)},
          "the matrix has to have a row and a column for each order"},
         {"Coefficient", {{0.5}, {{1.0}}, one_by_one(NAN)}, "coefficients have to be finite"},
         {"Order", {{-0.5}, {{1.0}}, one_by_one(1.0)}, "orders have to be 0 or above"},
         {"Missing", {{1.5}, {{1.0}}, one_by_one(1.0)}, "an initial value is missing"},
         {"NoList", {{1.5}, {}, one_by_one(1.0)}, "a list of initial values is needed for each order"},
         {"Initial", {{0.5}, {{INFINITY}}, one_by_one(1.0)}, "initial values have to be finite"},
         {"Load", {{0.5}, {{1.0}}, one_by_one(1.0), {{{1.0, -1.0}}}}, "powers of loads have to be above -1"},
         {"Loads",
          {{0.5}, {{1.0}}, one_by_one(1.0), {{}, {}}},
          "there have to be no loads, or a list of them for each order"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(LinearSystem, RejectsTimesAndDigitsThatAreNone) {
  const Reference solution =
      linear_reference({.orders = {0.5}, .initial = {{1.0}}, .matrix = one_by_one(-1.0)});
  EXPECT_THROW(solution.at(-1.0), std::invalid_argument);
  EXPECT_THROW(solution.at(NAN), std::invalid_argument);
  EXPECT_THROW(solution.digits(1.0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fde::reference
