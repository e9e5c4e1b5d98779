// SPDX-License-Identifier: MIT
// Tarasov & Zaslavsky 2006, the two-dimensional example: eqs 61-66, as printed and corrected, for the exact
// solution of eqs 59, 60.

#include "support/caputo.hpp"
#include "support/linear_system_testing.hpp"

namespace fde::bench {
namespace {

// x = (q1 + q2)/2, y = (q1 - q2)/2 and the other terms of eqs 61-66, for u = (q1^2 - q2^2)/4, that is, K = x.
struct State {
  double x, dx, ddx, ddy;
  double d_alpha_x, rate_of_d_alpha_x, rate_of_d_alpha_y;  // D^alpha x, D^1 D^alpha x, D^1 D^alpha y
  double integral_of_k, rate_of_integral_of_k;             // J^(2-alpha) K and its derivative
  double d_rest_x, d_rest_dx;                              // D^(2-alpha) x and of x'
};

constexpr double g = 0.8, x0 = 0.7, y0 = -0.2, dy0 = 0.5;  // x'(0) = 0: on the constraint with C0 = 0

// Eqs 59, 60 integrated once: p2 = q2' + (g/2) D^alpha q2 has p2' = x/2, and p1 + p2 is constant. The last
// four components are the fractional integrals J^(2-alpha) of x', y' and x, and J^(alpha-1) of x'.
reference::Reference solution_of_59_and_60(double alpha) {
  enum Row : Eigen::Index { q1, q2, v2, p2, of_dx, of_dy, of_x, rest_of_dx };
  const double total = 0.0;  // p1 + p2 = 2 x'(0)
  Matrix m = Matrix::Zero(8, 8);
  m(q1, p2) = -2.0, m(q1, v2) = 1.0;  // q1' = p1 - p2 + v2
  m(q2, v2) = 1.0;
  m(v2, p2) = 2.0 / g, m(v2, v2) = -2.0 / g;
  m(p2, q1) = m(p2, q2) = 0.25;
  m.row(of_dx) = 0.5 * (m.row(q1) + m.row(q2));
  m.row(of_dy) = 0.5 * (m.row(q1) - m.row(q2));
  m(of_x, q1) = m(of_x, q2) = 0.5;
  m.row(rest_of_dx) = m.row(of_dx);
  return reference::linear_reference(reference::LinearSystem{
      .orders = {1.0, 1.0, alpha - 1.0, 1.0, 2.0 - alpha, 2.0 - alpha, 2.0 - alpha, alpha - 1.0},
      .initial = {{x0 + y0}, {x0 - y0}, {-dy0}, {-dy0}, {0.0}, {0.0}, {0.0}, {0.0}},
      .matrix = m,
      .loads = {{{total}}, {}, {}, {}, {}, {{-dy0}}, {}, {}}});
}

// Derivatives by central differences of rate 4 of values with 40 digits.
State state_at(double t, double alpha) {
  const auto precision = test_precision();
  const reference::Reference solution = solution_of_59_and_60(alpha);
  const reference::BigReal h("1e-6");
  std::vector<std::vector<reference::BigReal>> at;
  for (int k = -2; k <= 2; ++k) at.push_back(digits_at(solution, std::round(1e6 * t + k) / 1e6));
  const auto first = [&](std::size_t i) {
    return reference::BigReal((at[0][i] - 8 * at[1][i] + 8 * at[3][i] - at[4][i]) / (12 * h))
        .convert_to<double>();
  };
  const auto second = [&](std::size_t i) {
    return reference::BigReal((-at[0][i] + 16 * at[1][i] - 30 * at[2][i] + 16 * at[3][i] - at[4][i]) /
                              (12 * h * h))
        .convert_to<double>();
  };
  const auto x = reference::BigReal((at[2][0] + at[2][1]) / 2).convert_to<double>();
  return {.x = x,
          .dx = (first(0) + first(1)) / 2,
          .ddx = (second(0) + second(1)) / 2,
          .ddy = (second(0) - second(1)) / 2,
          .d_alpha_x = first(4),
          .rate_of_d_alpha_x = second(4),
          .rate_of_d_alpha_y = second(5),
          .integral_of_k = at[2][6].convert_to<double>(),
          .rate_of_integral_of_k = first(6),
          .d_rest_x = at[2][7].convert_to<double>(),
          .d_rest_dx = first(7)};
}

constexpr double rounding = 1e-13;

TEST(ErrataTarasov, Equation61LosesAHalf) {
  for (const double alpha : {1.3, 1.5}) {
    const State s = state_at(0.5, alpha);
    EXPECT_NEAR(s.ddx + g / 2 * s.rate_of_d_alpha_x - g / 2 * s.rate_of_d_alpha_y, 0.0, rounding);
    EXPECT_NEAR(s.ddy + s.x / 2, 0.0, rounding);
    const double printed_x = s.ddx + g * s.rate_of_d_alpha_x - g * s.rate_of_d_alpha_y,
                 printed_y = s.ddy + s.x;
    if (alpha == 1.5) {
      EXPECT_NEAR(std::abs(printed_x), 0.0942210, 1e-7);
      EXPECT_NEAR(std::abs(printed_y), 0.3397271, 1e-7);
    }
    // g = b2/(2c) would correct the first equation, but not the second, which has no g.
    EXPECT_GT(std::abs(printed_x), 0.05);
    EXPECT_GT(std::abs(printed_y), 0.3);
  }
}

TEST(ErrataTarasov, Equation63LosesHalvesToo) {
  const State s = state_at(0.5, 1.5);
  EXPECT_NEAR(s.ddx + g / 2 * s.rate_of_d_alpha_x + g / 4 * s.rate_of_integral_of_k, 0.0, rounding);
  EXPECT_NEAR(std::abs(s.ddx + g * s.rate_of_d_alpha_x + g * s.rate_of_integral_of_k), 0.3012218, 1e-7);
}

// For y = y'(0) t + 0.3 t^2, D^(1/2) y is J^(3/2) y'' plus a term in y'(0).
TEST(ErrataTarasov, Equation63NeedsAnOrderAboveOne) {
  const double alpha = 0.5, t = 2.0;
  const double left =
      dy0 * caputo_derivative_of_power(1.0, alpha, t) + 0.3 * caputo_derivative_of_power(2.0, alpha, t);
  const double from_acceleration = fractional_integral([](double) { return 0.6; }, 2.0 - alpha, t);
  EXPECT_NEAR(left - from_acceleration, 0.797884560802865, 1e-12);
  EXPECT_NEAR(left - from_acceleration, dy0 * std::pow(t, 1.0 - alpha) / reference::gamma(2.0 - alpha),
              1e-12);
  EXPECT_NEAR(0.3 * caputo_derivative_of_power(2.0, 1.5, t),
              fractional_integral([](double) { return 0.6; }, 0.5, t), 1e-12);
}

// 1 < alpha < 2 and C = 0; the printed eq. 64 would require alpha > 2.
TEST(ErrataTarasov, Equation64HasTheInverseOfG) {
  const State s = state_at(0.5, 1.5);
  EXPECT_NEAR(s.dx + g / 2 * s.d_alpha_x + g / 4 * s.integral_of_k, 0.0, rounding);
  EXPECT_NEAR(std::abs(s.dx + s.d_alpha_x / g + g * s.integral_of_k), 0.2461300, 1e-7);
  EXPECT_NEAR(std::abs(s.dx + g * s.d_alpha_x + g * s.integral_of_k), 0.2903211, 1e-7);
}

// D^(1+e) x + (g/2) x'' + (g/4) K = 0, e = 2 - alpha; printed D^e x and the inverse of g.
TEST(ErrataTarasov, Equation65LosesAnOrderOfItsDamping) {
  for (const double alpha : {1.3, 1.5}) {
    const State s = state_at(0.5, alpha);
    EXPECT_NEAR(s.d_rest_dx + g / 2 * s.ddx + g / 4 * s.x, 0.0, rounding);
    EXPECT_GT(std::abs(s.d_rest_x + s.ddx / g + g * s.x), 0.1);
    EXPECT_GT(std::abs(s.d_rest_x + g / 2 * s.ddx + g / 4 * s.x), 0.05);
  }
}

// Eq. 65 with m = 2, divided by g/2: x'' + K/2 + (2/g) D^(3-alpha) x = 0. With the damping corrected but the
// factors of 62, x'' + K + (1/g) D^(3-alpha) x, the equation is still wrong.
TEST(ErrataTarasov, Equation66LosesAnOrderOfItsDamping) {
  struct Off {
    double t, printed, with_factors_of_62;
  };
  for (const auto& [t, printed, with_factors_of_62] :
       {Off{0.5, 0.3847699, 0.3699841 / g}, Off{2.0, 0.1800543, 0.2905724 / g}}) {
    const State s = state_at(t, 1.5);
    EXPECT_NEAR(s.ddx + s.x / 2 + 2 / g * s.d_rest_dx, 0.0, rounding);
    EXPECT_NEAR(std::abs(s.ddx / g + s.d_rest_x + g * s.x), printed, 1e-7);
    EXPECT_NEAR(std::abs(s.ddx + s.x + s.d_rest_dx / g), with_factors_of_62, 2e-7);
  }
}

}  // namespace
}  // namespace fde::bench
