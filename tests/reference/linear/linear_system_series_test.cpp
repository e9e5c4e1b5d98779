// SPDX-License-Identifier: MIT
// Linear systems compared with their power series, with an inversion without determinants, and with their own
// bounds.

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "fdebench/reference/special_functions/laplace/enclosing_contour.hpp"
#include "support/linear_system_testing.hpp"

namespace fde::reference {
namespace {

// x_i = x_i(0) + J^(g_i) [A x + b]_i, solved term by term: in the basis t^e / Gamma(e+1), J^g only shifts the
// exponent m g_1 + n g_2.
TEST(LinearSystem, IsItsPowerSeries) {
  const auto precision = bench::test_precision();
  constexpr std::size_t most = 160;
  const Matrix a = (Matrix(2, 2) << -1.0, 0.7, -2.0, -0.3).finished();
  const LinearSystem system{
      .orders = {0.6, 0.85}, .initial = {{1.0}, {-0.5}}, .matrix = a, .loads = {{{0.4}}, {{-0.2}}}};
  const auto entry = [&](int i, int j) { return from_shortest_decimal<BigReal>(a(i, j)); };
  using Lattice = std::vector<std::vector<BigReal>>;
  Lattice x(most + 1, std::vector(most + 1, BigReal(0))), y = x;
  const BigReal t("0.8"), g1("0.6"), g2("0.85");
  BigReal sum_x(0), sum_y(0);
  for (std::size_t m = 0; m <= most; ++m) {
    for (std::size_t n = 0; m + n <= most; ++n) {
      if (m + n == 0) {
        x[0][0] = 1;
        y[0][0] = BigReal("-0.5");
      }
      if (m > 0) x[m][n] = entry(0, 0) * x[m - 1][n] + entry(0, 1) * y[m - 1][n];
      if (n > 0) y[m][n] = entry(1, 0) * x[m][n - 1] + entry(1, 1) * y[m][n - 1];
      if (m == 1 && n == 0) x[m][n] += BigReal("0.4");
      if (m == 0 && n == 1) y[m][n] -= BigReal("0.2");
      const BigReal exponent = BigReal(m) * g1 + BigReal(n) * g2,
                    power = pow(t, exponent) / gamma(BigReal(exponent + 1));
      sum_x += x[m][n] * power;
      sum_y += y[m][n] * power;
    }
  }
  const auto values = bench::digits_at(linear_reference(system), 0.8);
  bench::expect_equal(values[0], sum_x, "x");
  bench::expect_equal(values[1], sum_y, "y");
}

// In long double and in multiprecision, for stiff and growing systems: the bound holds, and is small compared
// with max(|x|, |t x'|).
TEST(LinearSystem, DoublesAreWithinTheirBounds) {
  const auto precision = bench::test_precision();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 30; ++i) {
    LinearSystem system;
    for (int j = 0; j < 2; ++j) {
      system.orders.push_back(std::ceil(40.0 * unit(random)) / 20.0);
      system.initial.emplace_back(initial_count(system.orders.back()), unit(random));
    }
    const double size = std::pow(10.0, 6.0 * unit(random) - 2.0);
    system.matrix = Matrix::NullaryExpr(2, 2, [&] { return size * (unit(random) - 0.8); });
    const Reference solution = linear_reference(system);
    for (const double t : {0.01, 0.5, 3.0}) {
      const ReferenceValue known = solution.at(t);
      if (!known.value.allFinite()) continue;
      const auto exact = bench::digits_at(solution, t),
                 later = bench::digits_at(solution, t * (1.0 + 0x1p-20));
      for (std::size_t j = 0; j < 2; ++j) {
        const auto k = static_cast<Eigen::Index>(j);
        const BigReal error = abs(BigReal(exact[j] - known.value[k])),
                      rate = abs(BigReal((later[j] - exact[j]) * 0x1p20));
        EXPECT_LE(error, known.bound[k]) << i << " " << t;
        const BigReal scale = std::max(BigReal(abs(exact[j])), rate);
        worst = std::max(worst, BigReal(known.bound[k] / scale).convert_to<double>());
      }
    }
  }
  EXPECT_LE(worst, 7e-16);  // 5e-16 plus the rounding of the value
}

using BigMatrix = std::vector<std::vector<BigComplex>>;

// Gaussian elimination without pivoting: accurate for the matrices below on a contour away from their zeros.
std::vector<BigComplex> solve(BigMatrix m, std::vector<BigComplex> r) {
  const std::size_t size = r.size();
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = k + 1; i < size; ++i) {
      const BigComplex factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < size; ++j) m[i][j] -= factor * m[k][j];
      r[i] -= factor * r[k];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j) r[k] -= m[k][j] * r[j];
    r[k] /= m[k][k];
  }
  return r;
}

// (diag(s^g) - A)^-1 diag(s^(g-1)) x0 on a parabola around all singularities: |s| <= the norm of the matrix,
// if that is at least 1 and no order is below 1.
TEST(LinearSystem, AgreesWithEliminationOnAnEnclosingContour) {
  const auto precision = bench::test_precision();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const std::vector<double>& orders :
       {std::vector{1.0, 1.1, 1.2, 1.3}, {1.0, 1.0, 1.9}, {1.5, 1.25, 1.5, 1.0, 1.75, 2.0}}) {
    const auto size = static_cast<Eigen::Index>(orders.size());
    const Matrix a =
        Matrix::NullaryExpr(size, size, [&] { return std::round(64.0 * uniform(random)) / 64.0; });
    LinearSystem system{.orders = orders, .initial = {}, .matrix = a};
    for (std::size_t i = 0; i < orders.size(); ++i)
      system.initial.push_back({uniform(random) > 0.0 ? 1.0 : -2.0});
    for (std::size_t i = 0; i < orders.size(); ++i) system.initial[i].resize(initial_count(orders[i]), 0.0);
    const long double radius = 1.0L + a.cwiseAbs().rowwise().sum().maxCoeff();
    const EnclosingContour contour({{radius, radius}, {radius, -radius}, {0.0L, 0.0L}}, 55);
    const Precision working(contour.working_digits() + 20);
    std::vector<BigReal> sums(orders.size(), BigReal(0));
    for (const auto& node : contour.upper_nodes()) {
      BigMatrix m(orders.size(), std::vector<BigComplex>(orders.size()));
      std::vector<BigComplex> r;
      for (std::size_t i = 0; i < orders.size(); ++i) {
        for (std::size_t j = 0; j < orders.size(); ++j)
          m[i][j] = BigComplex(-a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
        const BigComplex power = exp(BigComplex(from_shortest_decimal<BigReal>(orders[i]) * node.log_s));
        m[i][i] += power;
        r.push_back(power / node.s * system.initial[i][0]);
      }
      const auto x = solve(m, r);
      for (std::size_t i = 0; i < orders.size(); ++i)
        sums[i] += 2 * real_part<BigReal>(BigComplex(node.weight * x[i]));
    }
    const auto values = bench::digits_at(linear_reference(system), 1.0);
    for (std::size_t i = 0; i < orders.size(); ++i)
      bench::expect_equal(values[i], sums[i], fmt::format("{} of {}", i, orders.size()), BigReal(1));
  }
}

}  // namespace
}  // namespace fde::reference
