// SPDX-License-Identifier: MIT
// Caputo derivatives of piecewise quadratic interpolants: exact values for t and t^2, published coefficients,
// order 1.

#include "fdebench/schemes/rules/interpolants/parabolas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "fdebench/schemes/history/weights/polylogarithm.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr int parabola_steps = 40;

Problem of_order(double order) {
  return {.components = {{order, {0.0}}}, .rhs = [](double, In, Out f) { f.setZero(); }};
}

std::vector<Grid> grids() {
  return {{2.0, parabola_steps}, {2.0, parabola_steps, 1.5}, {2.0, parabola_steps, 4.0}};
}

// The derivatives at all t* of a function y with y(0) = 0.
template <class Parabolas>
std::vector<double> derivatives(double order, const Grid& grid, const std::function<double(double)>& y,
                                HistoryKind history) {
  const Problem problem = of_order(order);
  Parabolas parabolas(problem, grid, {.history = history});
  std::vector<double> values;
  Vec known(1), newest(1);
  for (int n = 1; n <= grid.steps; ++n) {
    const double increment = y(grid.time(n)) - y(grid.time(n - 1));
    parabolas.derivative(n, known, newest);
    values.push_back(known[0] + newest[0] * increment);
    if (n < grid.steps) parabolas.push(n, Vec::Constant(1, increment));
  }
  return values;
}

double caputo_derivative_of_power(double order, double p, double t) {
  return std::tgamma(p + 1.0) / std::tgamma(p + 1.0 - order) * std::pow(t, p - order);
}

class ParabolasOfOrder : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(, ParabolasOfOrder, testing::Values(0.05, 0.3, 0.5, 0.8, 0.97, 1.0));

// At sigma = 1 - g/2 the line on the newest step is exact for t^2, too.
TEST_P(ParabolasOfOrder, FromAheadAreExactForSquaresOnEveryGrid) {
  const double order = GetParam(), sigma = 1.0 - 0.5 * order;
  for (const auto& grid : grids()) {
    for (const auto history : {HistoryKind::direct, HistoryKind::exponentials}) {
      for (const double p : {1.0, 2.0}) {
        const auto values = derivatives<ForwardParabolas>(
            order, grid, [=](double t) { return std::pow(t, p); }, history);
        for (int n = 1; n <= parabola_steps; ++n) {
          const double at = grid.time(n) - (1.0 - sigma) * grid.step(n),
                       exact = caputo_derivative_of_power(order, p, at);
          EXPECT_NEAR(values[static_cast<std::size_t>(n - 1)], exact, 2e-13 * exact)
              << "p " << p << ", grading " << grid.grading << ", n " << n;
        }
      }
    }
  }
}

// The error for t^2 is the second difference of the first step: the integral of 2 s - t_1 over this step.
TEST_P(ParabolasOfOrder, FromBehindMissTheFirstBendOfSquaresOnEveryGrid) {
  const double order = GetParam();
  for (const auto& grid : grids()) {
    for (const auto history : {HistoryKind::direct, HistoryKind::exponentials}) {
      const auto values = derivatives<BackwardParabolas>(
          order, grid, [](double t) { return t * t; }, history);
      for (int n = 1; n <= parabola_steps; ++n) {
        const double t = grid.time(n), first = grid.step(1);
        double bend = n == 1 ? first : 0.0;  // for order 1
        if (order < 1.0) {
          const auto [left, right] = interval_weights(1.0 - order, t - grid.time(1), first);
          bend = first * (right - left);
        }
        const double exact = caputo_derivative_of_power(order, 2.0, t);
        EXPECT_NEAR(values[static_cast<std::size_t>(n - 1)], exact - bend, 2e-13 * exact)
            << "grading " << grid.grading << ", n " << n;
      }
    }
  }
}

// Gao, Sun & Zhang 2014, (2.12)-(2.16): the coefficient c_j, at step k, of the increment j steps ago, in
// units of h^-g / Gamma(2-g).
double published_l1_2(double g, int j, int k) {
  const auto a = [=](double l) { return std::pow(l + 1, 1 - g) - std::pow(l, 1 - g); };
  const auto b = [=](double l) {
    return (std::pow(l + 1, 2 - g) - std::pow(l, 2 - g)) / (2 - g) -
           (std::pow(l + 1, 1 - g) + std::pow(l, 1 - g)) / 2;
  };
  if (k == 1) return 1.0;
  if (j == 0) return a(0) + b(0);
  return j == k - 1 ? a(j) - b(j - 1) : a(j) + b(j) - b(j - 1);
}

// Alikhanov 2015, (25)-(26): the same for L2-1_sigma.
double published_l2_1_sigma(double g, int j, int k) {
  const double s = 1 - g / 2;
  const auto a = [=](double l) {
    return l == 0 ? std::pow(s, 1 - g) : std::pow(l + s, 1 - g) - std::pow(l - 1 + s, 1 - g);
  };
  const auto b = [=](double l) {
    return (std::pow(l + s, 2 - g) - std::pow(l - 1 + s, 2 - g)) / (2 - g) -
           (std::pow(l + s, 1 - g) + std::pow(l - 1 + s, 1 - g)) / 2;
  };
  if (k == 1) return a(0);
  if (j == 0) return a(0) + b(1);
  return j == k - 1 ? a(j) - b(j) : a(j) + b(j + 1) - b(j);
}

template <class Parabolas>
void expect_published(double order, double (*coefficient)(double g, int j, int k)) {
  const Grid grid{parabola_steps, parabola_steps};
  for (int m = 1; m <= parabola_steps; ++m) {  // the one increment that is not 0
    const auto values = derivatives<Parabolas>(
        order, grid, [=](double t) { return t >= m ? 1.0 : 0.0; }, HistoryKind::direct);
    for (int n = 1; n <= parabola_steps; ++n) {
      const double value = std::tgamma(2.0 - order) * values[static_cast<std::size_t>(n - 1)];
      EXPECT_NEAR(value, n < m ? 0.0 : coefficient(order, n - m, n), 2e-13) << "n " << n << ", m " << m;
    }
  }
}

TEST_P(ParabolasOfOrder, FromBehindHaveTheCoefficientsOfGaoSunAndZhang) {
  if (GetParam() == 1.0) return;  // the published formula has 0^0
  expect_published<BackwardParabolas>(GetParam(), published_l1_2);
}
TEST_P(ParabolasOfOrder, FromAheadHaveTheCoefficientsOfAlikhanov) {
  expect_published<ForwardParabolas>(GetParam(), published_l2_1_sigma);
}

const Problem logistic{
    .components = {{1.0, {0.2}}},
    .rhs = [](double t, In y, Out f) { f[0] = y[0] * (1.0 - y[0]) + std::sin(t); },
    .derivatives = DenseJacobian{[](double, In y, OutMatrix j) { j(0, 0) = 1.0 - 2.0 * y[0]; }},
    .end = 2.0};

// (y_n - y_(n-1)) / h = f at the midpoint.
TEST(L2OneSigma, OfOrderOneIsTheMidpointRule) {
  for (const auto& grid : grids()) {
    const auto path = solve("l2_1_sigma", logistic, grid);
    Vec f(1);
    for (int n = 1; n <= parabola_steps; ++n) {
      const double h = grid.step(n);
      logistic.rhs(grid.time(n) - 0.5 * h, 0.5 * (path.y.col(n) + path.y.col(n - 1)), f);
      EXPECT_NEAR(path.y(0, n) - path.y(0, n - 1), h * f[0], 1e-14) << grid.grading << ' ' << n;
    }
  }
}

// With r = h_n / h_(n-1): (y_n - y_(n-1)) (1 + 2r) / (1 + r) - (y_(n-1) - y_(n-2)) r^2 / (1 + r) = h_n f_n.
TEST(L1Two, OfOrderOneIsBdf2AfterBackwardEuler) {
  for (const auto& grid : grids()) {
    const auto path = solve("l1_2", logistic, grid);
    Vec f(1);
    for (int n = 1; n <= parabola_steps; ++n) {
      const double h = grid.step(n), r = n == 1 ? 0.0 : h / grid.step(n - 1);
      logistic.rhs(grid.time(n), path.y.col(n), f);
      const double newest = path.y(0, n) - path.y(0, n - 1);
      const double before = n == 1 ? 0.0 : path.y(0, n - 1) - path.y(0, n - 2);
      EXPECT_NEAR((newest * (1 + 2 * r) - before * r * r) / (1 + r), h * f[0], 1e-14) << grid.grading;
    }
  }
}

// Uncoupled rows, each evaluated at the t* of its order.
TEST(L2OneSigma, OfSeveralOrdersIsThatOfEach) {
  const auto rows = [](const std::vector<double>& orders) {
    Problem problem{.rhs = [](double t, In y, Out f) { f = (-y.array() * y.array() + std::cos(t)).matrix(); },
                    .end = 2.0};
    for (const double order : orders) problem.components.push_back({order, {0.3}});
    return problem;
  };
  const auto& scheme = *find_scheme("l2_1_sigma");
  for (const auto& grid : grids()) {
    const Rows both = scheme.solve(rows({0.4, 0.9, 0.4}), grid, {}).y;
    EXPECT_LT((both.row(0) - scheme.solve(rows({0.4}), grid, {}).y.row(0)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((both.row(1) - scheme.solve(rows({0.9}), grid, {}).y.row(0)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ((both.row(2) - both.row(0)).cwiseAbs().maxCoeff(), 0.0);
  }
}

// zeta(-p, 1) = zeta(-p): -1/2, -1/12, 0, 1/120; zeta(-1/2), zeta(-7) = 1/240; zeta(-p, 1/2) = (2^-p - 1)
// zeta(-p).
TEST(HurwitzZeta, HasItsKnownValues) {
  const auto expect = [](double p, double a, double value) {
    EXPECT_NEAR(static_cast<double>(hurwitz_zeta_at_minus(p, a)), value, 1e-15) << p << ' ' << a;
  };
  expect(0.0, 1.0, -0.5);
  expect(1.0, 1.0, -1.0 / 12.0);
  expect(2.0, 1.0, 0.0);
  expect(3.0, 1.0, 1.0 / 120.0);
  expect(0.5, 1.0, -0.207886224977354566017307253970);
  expect(7.0, 1.0, 1.0 / 240.0);
  expect(1.0, 0.5, 1.0 / 24.0);
  expect(7.0, 0.5, (std::ldexp(1.0, -7) - 1.0) / 240.0);
}

TEST(HurwitzZeta, LosesTheFirstTermWhereItsShiftIsOneMore) {
  for (const double p : {0.3, 2.7, 5.99, 6.01, 9.4}) {
    const auto difference = hurwitz_zeta_at_minus(p, 1e-9L) - hurwitz_zeta_at_minus(p, 1.0L);
    EXPECT_NEAR(static_cast<double>(difference), std::pow(1e-9, p), 1e-7) << p;
  }
}

// Phi(zeta, s, 1) zeta = Li_s(zeta).
TEST(LerchFunction, WithShiftOneIsThePolylogarithm) {
  for (const double s : {0.0, -0.2, -0.5, -0.9, -1.0, -1.5, -2.0}) {
    const Lerch lerch(s, 1.0);
    for (const ComplexValue mu :
         {ComplexValue{0.0, 1e-8}, {0.0, 0.5}, {0.0, 3.1}, {-0.7, 3.0}, {-0.3, 0.0}}) {
      const ComplexValue own = lerch.scaled(mu) * std::exp(mu), other = scaled_polylogarithm(s, mu);
      EXPECT_LT(std::abs(own - other), 2e-13 * (1.0 + std::abs(other))) << s << ' ' << mu;
    }
  }
}

}  // namespace
}  // namespace fde::bench
