// SPDX-License-Identifier: MIT
// The generating functions of the weights, on and inside the unit circle.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdebench/schemes/diagnostics/stability_region.hpp"
#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using std::numbers::pi;
using Value = ComplexValue;

std::vector<double> all_orders() {
  std::vector<double> orders{0.01, 0.99, 0.999, 1.001, 1.99, 2.0};
  for (int i = 1; i < 20; ++i) orders.push_back(0.1 * i);
  return orders;
}

std::vector<double> angles() {
  std::vector<double> result;
  for (double theta = 1e-9; theta < 1.0; theta *= 30.0) result.push_back(theta);
  for (int i = 1; i <= 32; ++i) result.push_back(pi * i / 32);
  return result;
}

double relative(Value a, Value b) { return std::abs(a - b) / std::abs(b); }

TEST(GeneratingFunction, AtWholeOrdersIsRational) {
  using namespace families;
  for (const double theta : angles()) {
    const Value mu{0.0, theta}, zeta = std::exp(mu);
    const Value one_minus{2.0 * std::pow(std::sin(0.5 * theta), 2), -std::sin(theta)};
    EXPECT_LT(relative(generating_function({&rectangle, 1.0}, mu), zeta / one_minus), 1e-13);
    EXPECT_LT(relative(generating_function({&grunwald_letnikov, 2.0}, mu), std::pow(one_minus, -2)), 1e-13);
    EXPECT_LT(relative(generating_function({&l1, 1.0}, mu), 1.0), 1e-13);
    const Value squared = 1.0 / (one_minus * one_minus);
    // zeta = -1 is a zero of these two, which are sums of terms of the size 1 + |W|.
    EXPECT_LT(std::abs(generating_function({&trapezoid, 1.0}, mu) - (1.0 + zeta) / one_minus),
              1e-13 * std::abs(1.0 + 1.0 / one_minus));
    EXPECT_LT(std::abs(generating_function({&rectangle, 2.0}, mu) - zeta * (1.0 + zeta) * squared),
              1e-13 * (1.0 + std::abs(squared)));
    EXPECT_LT(std::abs(generating_function({&trapezoid, 2.0}, mu) - (1.0 + 6.0 * zeta * squared)),
              1e-13 * (1.0 + std::abs(squared)));
  }
}

// Li_s(zeta) + Li_s(-zeta) = 2^(1-s) Li_s(zeta^2) relates the values at three points for every order.
TEST(GeneratingFunction, ObeysTheDuplicationFormula) {
  const auto polylogarithm = [](double s, double theta) {
    const Value mu{0.0, theta}, one_minus = 1.0 - std::exp(mu);
    return generating_function({&families::rectangle, -s}, mu) / one_minus;
  };
  for (const double order : all_orders()) {
    for (const double theta : {0.1, 0.4, 0.9, 1.3, 1.5}) {
      const Value sum = polylogarithm(-order, theta) + polylogarithm(-order, theta - pi);
      const Value twice = std::pow(2.0, 1.0 + order) * polylogarithm(-order, 2.0 * theta);
      EXPECT_LT(std::abs(sum - twice), 2e-13 * std::abs(polylogarithm(-order, theta)))
          << order << ' ' << theta;
    }
  }
}

TEST(GeneratingFunction, InsideTheCircleIsThePowerSeries) {
  for (const auto* const family :
       {&families::rectangle, &families::trapezoid, &families::grunwald_letnikov, &families::l1,
        &families::bdf2, &families::bdf3, &families::bdf4, &families::bdf5, &families::bdf6,
        &families::newton_gregory_3, &families::fractional_trapezoidal}) {
    for (const double order : all_orders()) {
      if (family->acts_on_increments && order > 1.0) continue;
      const WeightTable table{family, order};
      for (const Value mu : {Value{-0.65, 0.3}, {-0.65, 2.9}, {-0.2, 0.0}, {-0.2, 1.0}, {-0.2, pi}}) {
        Value sum = family == &families::rectangle ? 0.0 : 1.0;
        double size = 1.0;
        for (int k = 1; k < 250; ++k) {
          const Value term = weight(table, k) * std::exp(static_cast<double>(k) * mu);
          sum += term;
          size += std::abs(term);
        }
        EXPECT_LT(std::abs(generating_function(table, mu) - sum), 3e-14 * size) << order << ' ' << mu;
      }
    }
  }
}

TEST(GeneratingFunction, NextToOneIsThatOfTheIntegral) {
  for (const double order : {0.01, 0.1, 0.5}) {
    const Value mu{0.0, 1e-250};
    for (const auto* const family :
         {&families::rectangle, &families::trapezoid, &families::grunwald_letnikov, &families::bdf2,
          &families::bdf6, &families::newton_gregory_2, &families::fractional_trapezoidal}) {
      const WeightTable table{family, order};
      EXPECT_LT(relative(step_factor(table, 1.0) * generating_function(table, mu), std::pow(-mu, -order)),
                1e-13);
    }
  }
}

// The response of a scheme to a right-hand side that is 1 at one step is its weights. The generating function
// of their m-th differences, times (1 - zeta)^(-m), is the symbol on the unit circle.
class Impulse : public testing::TestWithParam<const Scheme*> {};

// The impulse is at the third step, where no rule has a special starting formula.
Value response_on_circle(const Scheme& scheme, double order, double theta, int differences) {
  constexpr int before = 2, steps = 500;
  const Problem problem{.components = {{order, std::vector<double>(initial_count(order), 0.0)}},
                        .rhs = [](double t, In, Out f) { f[0] = t > before && t <= before + 1 ? 1.0 : 0.0; },
                        .derivatives = DenseLinearPart{Matrix::Zero(1, 1)},
                        .end = before + steps};
  Vec y = scheme.solve(problem, Grid{problem.end, before + steps}, {.history = HistoryKind::direct})
              .y.row(0)
              .tail(steps);
  for (int m = 0; m < differences; ++m) {
    for (Eigen::Index n = steps - 1; n > 0; --n) y[n] -= y[n - 1];
  }
  Value sum = 0.0;
  for (Eigen::Index n = steps; n-- > 0;)
    sum += y[n] * std::polar(1.0, std::fmod(theta * static_cast<double>(n), 2 * pi));
  return sum / std::pow(1.0 - std::polar(1.0, theta), differences);
}

TEST_P(Impulse, RunsGiveTheBoundaryToTenDigits) {
  for (int i = 1; i < 20; ++i) {
    const double order = 0.1 * i;
    if (order == 1.0) continue;  // no memory: the sums below do not converge
    for (const double theta : {0.7, 1.0, 1.7, 2.5, 3.0, pi}) {
      const bool between = GetParam()->id == "l2_1_sigma";
      if (between && order > 1.0 && theta == pi) continue;  // the midpoint rule has the value 0 there
      Value by_run = 1.0 / response_on_circle(*GetParam(), order, theta, 6);
      // The last link evaluates f between y_(n-1) and y_n.
      const double last = order > 1.0 ? order - 1.0 : order;
      if (between) by_run /= 1.0 - 0.5 * last * (1.0 - std::polar(1.0, theta));
      EXPECT_LT(relative(root_locus(*GetParam(), order, theta).front(), by_run), 1e-10)
          << order << ' ' << theta;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ImplicitSchemes, Impulse,
                         testing::Values(find_scheme("l1"), find_scheme("l1_2"), find_scheme("l2_1_sigma"),
                                         find_scheme("grunwald_letnikov"),
                                         find_scheme("product_trapezoidal")),
                         id_of_param);

}  // namespace
}  // namespace fde::bench
