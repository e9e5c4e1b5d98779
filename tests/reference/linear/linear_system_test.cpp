// SPDX-License-Identifier: MIT
// Linear systems compared with closed forms.

#include <fmt/format.h>

#include "support/linear_system_testing.hpp"

namespace fde::reference {
namespace {

Matrix scalar(double value) { return Matrix::Constant(1, 1, value); }

struct Single {
  const char* name;
  double order, rate;
};

class SingleComponent : public testing::TestWithParam<Single> {};

// At t = 1: x = x0 E_g(l) + x1 E_{g,2}(l) + sum of loads c Gamma(p+1) E_{g,g+p+1}(l).
TEST_P(SingleComponent, IsASumOfMittagLefflerFunctions) {
  const auto& [name, order, rate] = GetParam();
  const auto precision = bench::test_precision();
  std::vector<double> initial{3.0};
  if (order > 1.0) initial.push_back(-2.0);
  const Reference solution = linear_reference(
      {.orders = {order}, .initial = {initial}, .matrix = scalar(rate), .loads = {{{5.0}, {7.0, 2.0}}}});
  const auto e = [&, g = fmt::format("{}", order), z = fmt::format("{}", rate)](const BigReal& beta) {
    return real_part<BigReal>(bench::mittag_leffler_digits(g, beta.str(60), z));
  };
  const auto g = from_shortest_decimal<BigReal>(order);
  BigReal exact = 3 * e(BigReal(1)) + 5 * e(BigReal(g + 1)) + 14 * e(BigReal(g + 3));
  if (order > 1.0) exact -= 2 * e(BigReal(2));
  bench::expect_equal(bench::digits_at(solution, 1.0)[0], exact, name);
  const ReferenceValue known = solution.at(1.0);
  EXPECT_NEAR(known.value[0], exact.convert_to<double>(), 1.01 * known.bound[0]);
}

INSTANTIATE_TEST_SUITE_P(
    LinearSystem, SingleComponent,
    testing::Values(Single{"Slow", 0.1, -1.0}, Single{"Half", 0.5, -2.0}, Single{"Growing", 0.8, 3.0},
                    Single{"First", 1.0, -3.0}, Single{"Oscillating", 1.5, -4.0},
                    Single{"NearlyHarmonic", 1.99, -100.0}, Single{"Harmonic", 2.0, -9.0},
                    Single{"VeryStiffHalf", 0.5, -1e8}, Single{"VeryStiffFirst", 1.0, -1e8},
                    Single{"VeryStiffOscillating", 1.5, -1e8}, Single{"VeryStiffNearlyHarmonic", 1.99, -1e8}),
    [](const auto& test) { return std::string(test.param.name); });

// E_{1/2}(l sqrt(t)) ~ -sum_k l^-k t^(-k/2) / Gamma(1 - k/2): at l = -1e8 seven terms give 48 digits or more.
TEST(LinearSystem, VeryStiffRelaxationHasItsAsymptoticExpansion) {
  const auto precision = bench::test_precision();
  const Reference solution = linear_reference({.orders = {0.5}, .initial = {{1.0}}, .matrix = scalar(-1e8)});
  for (const double t : {0.25, 4.0}) {
    BigReal sum(0), power(1);
    for (int k = 1; k <= 7; ++k) {
      power /= BigReal(-1e8) * sqrt(BigReal(t));
      sum -= power * reciprocal_gamma(BigReal(1 - BigReal(k) / 2));
    }
    bench::expect_equal(bench::digits_at(solution, t)[0], sum, fmt::format("t = {}", t));
  }
}

// The fast transient e^(-1e8 t) at t = 1e-7, and the level 1e-8 of the load after it.
TEST(LinearSystem, VeryStiffExponentialHasItsTransient) {
  const auto precision = bench::test_precision();
  const Reference solution =
      linear_reference({.orders = {1.0}, .initial = {{1.0}}, .matrix = scalar(-1e8), .loads = {{{1.0}}}});
  const BigReal transient = exp(BigReal(-10)), level("1e-8");
  bench::expect_equal(bench::digits_at(solution, 1e-7)[0], transient + level * (1 - transient), "transient");
  bench::expect_equal(bench::digits_at(solution, 1.0)[0], level, "level");
}

struct Rate {
  const char* name;
  std::string order, re, im;
};

class ComplexPair : public testing::TestWithParam<Rate> {};

TEST_P(ComplexPair, IsRealAndImaginaryPart) {
  const auto& [name, order, re, im] = GetParam();
  const auto precision = bench::test_precision();
  const double a = std::stod(re), b = std::stod(im), g = std::stod(order);
  const auto initial = g > 1.0 ? std::vector{1.0, 0.0} : std::vector{1.0};
  const auto none = g > 1.0 ? std::vector{0.0, 0.0} : std::vector{0.0};
  const Reference solution = linear_reference(
      {.orders = {g, g}, .initial = {initial, none}, .matrix = (Matrix(2, 2) << a, -b, b, a).finished()});
  const auto exact = bench::mittag_leffler_digits(order, "1", re, im);
  const auto values = bench::digits_at(solution, 1.0);
  bench::expect_equal(values[0], real_part<BigReal>(exact), "x");
  bench::expect_equal(values[1], imag_part<BigReal>(exact), "y");
}

INSTANTIATE_TEST_SUITE_P(LinearSystem, ComplexPair,
                         testing::Values(Rate{"Stable", "0.8", "-1", "2"}, Rate{"Slow", "0.3", "-0.5", "0.1"},
                                         Rate{"EdgeOfStability", "0.5", "3", "3"},
                                         Rate{"Growing", "0.75", "2", "1.5"}, Rate{"First", "1", "-1", "30"},
                                         Rate{"Oscillating", "1.6", "-5", "1"},
                                         Rate{"VeryStiff", "0.8", "-1e8", "1e8"}),
                         [](const auto& test) { return std::string(test.param.name); });

class Defective : public testing::TestWithParam<Rate> {};

// D^g x = l x + y, D^g y = l y: at t = 1, y = y0 E_g(l), x = x0 E_g(l) + y0 E_g'(l), E_g' = E_{g,g} / g.
TEST_P(Defective, HasTheDerivativeOfTheMittagLefflerFunction) {
  const auto& [name, order, rate, unused] = GetParam();
  const auto precision = bench::test_precision();
  const double l = std::stod(rate), g = std::stod(order);
  const auto initial = g > 1.0 ? std::vector{2.0, 0.0} : std::vector{2.0};
  const Reference solution = linear_reference({.orders = {g, g},
                                               .initial = {initial, initial},
                                               .matrix = (Matrix(2, 2) << l, 1.0, 0.0, l).finished()});
  const BigReal e = real_part<BigReal>(bench::mittag_leffler_digits(order, "1", rate)),
                slope = real_part<BigReal>(bench::mittag_leffler_digits(order, order, rate)) / BigReal(order);
  const auto values = bench::digits_at(solution, 1.0);
  bench::expect_equal(values[0], 2 * e + 2 * slope, "x");
  bench::expect_equal(values[1], 2 * e, "y");
}

INSTANTIATE_TEST_SUITE_P(LinearSystem, Defective,
                         testing::Values(Rate{"Slow", "0.4", "-1", ""}, Rate{"Growing", "0.7", "2", ""},
                                         Rate{"First", "1", "-1.5", ""}, Rate{"Oscillating", "1.6", "-7", ""},
                                         Rate{"VeryStiff", "0.5", "-1e8", ""},
                                         Rate{"VeryStiffOscillating", "1.99", "-1e8", ""}),
                         [](const auto& test) { return std::string(test.param.name); });

// D x_i = -x_i + x_(i+1): e^-t times a polynomial; with order 1.6, zeros of that multiplicity off the cut.
TEST(LinearSystem, JordanBlocksOfSix) {
  const auto precision = bench::test_precision();
  constexpr int size = 6;
  Matrix block = -Matrix::Identity(size, size);
  block.diagonal(1).setOnes();
  std::vector<std::vector<double>> initial(size, {0.0});
  initial.back() = {1.0};
  const auto values = bench::digits_at(
      linear_reference({.orders = std::vector(size, 1.0), .initial = initial, .matrix = block}), 3.0);
  BigReal exact = exp(BigReal(-3));
  for (int i = 0; i < size; ++i) {
    bench::expect_equal(values[static_cast<std::size_t>(size - 1 - i)], exact, fmt::format("power {}", i));
    exact *= BigReal(3) / (i + 1);
  }
  for (auto& start : initial) start.push_back(0.0);
  const auto fractional = bench::digits_at(
      linear_reference({.orders = std::vector(size, 1.6), .initial = initial, .matrix = 2.0 * block}), 1.0);
  bench::expect_equal(fractional.back(), real_part<BigReal>(bench::mittag_leffler_digits("1.6", "1", "-2")),
                      "last");
  bench::expect_equal(fractional[size - 2],
                      real_part<BigReal>(bench::mittag_leffler_digits("1.6", "1.6", "-2")) * BigReal("1.25"),
                      "next");
}

}  // namespace
}  // namespace fde::reference
