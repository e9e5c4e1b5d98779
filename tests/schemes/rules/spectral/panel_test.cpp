// SPDX-License-Identifier: MIT
// Collocation on one panel: points, polynomials, and their fractional integrals.

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <utility>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "fdebench/schemes/rules/spectral/mode_count.hpp"
#include "fdebench/schemes/rules/spectral/panel_rule.hpp"

namespace fde::bench {
namespace {

constexpr Eigen::Index points = 20;

// The number of points of every accuracy.
class PanelRules : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Points, PanelRules, testing::Range(1, 27));

// Exact for polynomials of degree 2 n - 2: sum_j w_j P_k(x_j) P_l(x_j) = 2 / (2 l + 1) for k = l, else 0. The
// row of to_coefficients for P_l has the weights times (2 l + 1) / 2 P_l(x_j).
TEST_P(PanelRules, HaveThePointsOfRadauQuadrature) {
  const PanelRule rule(GetParam());
  const Matrix values = legendre_polynomials(rule.points, rule.size());
  const Matrix identity = Matrix::Identity(rule.size(), rule.size());
  EXPECT_LT((rule.to_coefficients * values - identity).cwiseAbs().maxCoeff(), 2e-14);
  const Vec twice_weights = rule.to_coefficients.row(0).transpose() * 2.0;
  EXPECT_GT(twice_weights.minCoeff(), 0.0);
  EXPECT_NEAR(twice_weights.dot(rule.points.array().pow(2).matrix()), rule.size() == 1 ? 2.0 : 2.0 / 3.0,
              1e-14);
  for (Eigen::Index j = 0; j < rule.size(); ++j) {
    const int n = GetParam();
    const double x = rule.points[j];
    EXPECT_NEAR(boost::math::legendre_p(n, x), boost::math::legendre_p(n - 1, x), 1e-14 * n * n) << x;
  }
}

// x^15 - 3 x^4 + 1.
Vec some_polynomial(const Vec& x) { return x.array().pow(15) - 3.0 * x.array().pow(4) + 1.0; }

TEST(PanelRule, AreExactForPolynomialsOnAPanelAndItsHalves) {
  const PanelRule rule(points);
  const Vec values = some_polynomial(rule.points);
  EXPECT_NEAR(rule.at_start.dot(values), -3.0, 1e-13);
  const Vec older = (rule.points.array() - 1.0) / 2.0, newer = (rule.points.array() + 1.0) / 2.0;
  EXPECT_LT((rule.to_older_half * values - some_polynomial(older)).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_LT((rule.to_newer_half * values - some_polynomial(newer)).lpNorm<Eigen::Infinity>(), 1e-13);
}

TEST(PanelRule, JoinTheHalvesOfAPolynomial) {
  const PanelRule rule(points);
  const Vec values = some_polynomial(rule.points);
  const Vec joined = rule.from_older * (rule.to_coefficients * (rule.to_older_half * values)) +
                     rule.from_newer * (rule.to_coefficients * (rule.to_newer_half * values));
  EXPECT_LT((joined - rule.to_coefficients * values).lpNorm<Eigen::Infinity>(), 1e-13);
}

// Exact to rounding: multipliers would correct any larger defect of a constraint where panels meet.
TEST(PanelRule, KeepConstants) {
  const PanelRule rule(points);
  EXPECT_NEAR(rule.at_start.sum(), 1.0, 1e-14);
  EXPECT_LT((rule.to_older_half.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-14);
  EXPECT_LT((rule.to_newer_half.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-14);
}

// Abramowitz & Stegun (1964), 25.4.31, list the Radau points mirrored: (6 -+ sqrt 6) / 10.
TEST(PanelRule, EndsWithThePanel) {
  const Vec places = PanelRule(3).points;
  EXPECT_NEAR(places[0], -(1.0 + std::sqrt(6.0)) / 5.0, 1e-15);
  EXPECT_NEAR(places[1], -(1.0 - std::sqrt(6.0)) / 5.0, 1e-15);
  EXPECT_EQ(places[2], 1.0);
}

// The fit of a step function, 1 and 0 on the halves, has its mean 1/2 and the coefficient -3/4 of P_1.
TEST(PanelRule, FitsTheHalvesOfAStep) {
  const PanelRule rule(points);
  const Vec joined = rule.from_older.col(0);
  EXPECT_NEAR(joined[0], 0.5, 1e-14);
  EXPECT_NEAR(joined[1], -0.75, 1e-14);
}

// z is 1 + beyond. The substitution w = (z - x)^order removes the singularity.
double moment_by_quadrature(double order, double beyond, int degree) {
  const double z = 1.0 + beyond, least = std::pow(std::max(beyond, 0.0), order),
               most = std::pow(2.0 + beyond, order);
  boost::math::quadrature::tanh_sinh<double> rule;
  const auto polynomial = [=](double w) {
    return boost::math::legendre_p(degree, std::clamp(z - std::pow(w, 1.0 / order), -1.0, 1.0));
  };
  return rule.integrate(polynomial, least, most) / (order * std::tgamma(order));
}

class KernelMoments : public testing::TestWithParam<double> {};

TEST_P(KernelMoments, AreTheIntegralsOfLegendrePolynomials) {
  const double order = GetParam();
  const Vec beyond{{-1.9, -1.0, -0.02, 1e-6, 4e-4, 5e-4, 0.1, 1.0, 30.0}};
  const Matrix moments = kernel_moments(order, beyond, 12);
  for (Eigen::Index j = 0; j < beyond.size(); ++j) {
    for (const int degree : {0, 1, 2, 5, 11}) {
      EXPECT_NEAR(moments(j, degree), moment_by_quadrature(order, beyond[j], degree),
                  1e-12 * std::max(1.0, moments(j, 0)))
          << beyond[j] << ' ' << degree;
    }
  }
}

TEST_P(KernelMoments, AreTheSameOfAPanelAtItsOwnPoints) {
  const double order = GetParam();
  for (const double since : {0.125, 1.0, 2.0}) {
    const Vec own = moments_inside_panel(order, since, 12);
    const Vec moments = kernel_moments(order, Vec::Constant(1, since - 2.0), 12).row(0).transpose();
    EXPECT_LT((own - moments).cwiseAbs().maxCoeff(), 1e-15 * own[0]) << since;
  }
}

// All polynomials are +1 or -1 at the start of the panel: the moments are +-s^order / Gamma(order + 1).
TEST_P(KernelMoments, StartAsPowersOfTheTimeSince) {
  const double order = GetParam(), since = 1e-30;
  const Vec own = moments_inside_panel(order, since, 12) * std::tgamma(order + 1.0) / std::pow(since, order);
  for (Eigen::Index l = 0; l < own.size(); ++l) EXPECT_NEAR(own[l], l % 2 == 0 ? 1.0 : -1.0, 1e-13) << l;
}

// Far away the moments of P_0 and P_1 are 2 z^(order-1) and 2/3 (1 - order) z^(order-2), over Gamma(order).
TEST_P(KernelMoments, FallFarAwayAsThePowersOfTheKernel) {
  const double order = GetParam(), z = 1e8;
  const Matrix moments = kernel_moments(order, Vec::Constant(1, z - 1.0), 2);
  const double first = 2.0 * std::pow(z, order - 1.0) / std::tgamma(order);
  EXPECT_NEAR(moments(0, 0) / first, 1.0, 1e-14);
  EXPECT_NEAR(moments(0, 1) / first, (1.0 - order) / (3.0 * z), 1e-15 / z);
}

INSTANTIATE_TEST_SUITE_P(Orders, KernelMoments, testing::Values(0.05, 0.5, 0.99, 1.0, 1.5, 2.0, 2.7));

TEST(KernelMoments, OfOrderOneAreZeroButForTheFirst) {
  const Matrix moments = kernel_moments(1.0, Vec{{0.01, 2.0}}, 8);
  EXPECT_EQ(moments.rightCols(7).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_NEAR(moments(0, 0), 2.0, 1e-15);
}

// D^g y = lambda y has the growing mode s = lambda^(1/g) for |arg lambda| < g pi / 2, otherwise none.
TEST(GrowingModes, OfAPairAreThoseInTheSector) {
  for (const double order : {0.3, 0.5, 0.9, 1.0, 1.4, 1.9}) {
    for (const double part : {0.1, 0.5, 0.9, 1.1, 1.6}) {
      const double size = 50.0, angle = part * order * std::numbers::pi / 2.0;
      if (angle > std::numbers::pi) continue;
      const double re = size * std::cos(angle), im = size * std::sin(angle);
      const Matrix pair{{re, -im}, {im, re}};
      const double rate = std::pow(size, 1.0 / order);
      const Vec orders = Vec::Constant(2, order);
      EXPECT_EQ(grows_faster(pair, orders, 0.5 * rate), part < 1.0) << order << ' ' << part;
      EXPECT_FALSE(grows_faster(pair, orders, 2.0 * rate)) << order << ' ' << part;
      const SparseMatrix sparse = pair.sparseView();
      EXPECT_EQ(grows_faster(sparse, order, 0.5 * rate), part < 1.0) << order << ' ' << part;
      EXPECT_FALSE(grows_faster(sparse, order, 2.0 * rate)) << order << ' ' << part;
    }
  }
}

// u'' = u as a chain of links 1.5 and 0.5, and u'' = -u.
TEST(GrowingModes, OfAChainAreThoseOfItsEquation) {
  const Vec orders{{1.5, 0.5}};
  const Matrix growing{{0.0, 1.0}, {1.0, 0.0}}, swinging{{0.0, 1.0}, {-1.0, -0.1}};
  EXPECT_TRUE(grows_faster(growing, orders, 0.9));
  EXPECT_FALSE(grows_faster(growing, orders, 1.1));
  EXPECT_FALSE(grows_faster(swinging, orders, 0.01));
}

// D^g x = a x + lambda, D^g z = b z - lambda, 0 = x - z: 2 D^g x = (a + b) x. An algebraic row with its own
// unknown, 0 = lambda - x, adds 1 to a.
TEST(GrowingModes, OfAlgebraicRowsAreThoseOfTheOthers) {
  const Matrix constrained{{5.0, 0.0, 1.0}, {0.0, 1.0, -1.0}, {1.0, -1.0, 0.0}};
  const Matrix eliminated{{2.0, 1.0}, {-1.0, 1.0}};
  for (const double order : {0.4, 1.0, 1.6}) {
    const double rate = std::pow(3.0, 1.0 / order);
    for (const auto& [matrix, orders] :
         {std::pair{constrained, Vec{{order, order, 0.0}}}, {eliminated, Vec{{order, 0.0}}}}) {
      EXPECT_TRUE(grows_faster(matrix, orders, 0.9 * rate)) << order;
      EXPECT_FALSE(grows_faster(matrix, orders, 1.1 * rate)) << order;
    }
  }
}

// The determinant of n copies is the n-th power of that of one, and turns n times as fast.
TEST(GrowingModes, OfManyCopiesAreThoseOfOne) {
  for (const Eigen::Index copies : {2, 11, 12, 14, 22, 43, 64}) {
    const Vec orders = Vec::Constant(copies, 0.7);
    const Matrix unit = Matrix::Identity(copies, copies);
    for (const double rate : {0.03, 1.0, 1e4}) {
      EXPECT_FALSE(grows_faster(-1e4 * unit, orders, rate)) << copies << ' ' << rate;
      EXPECT_TRUE(grows_faster(std::pow(2.0 * rate, 0.7) * unit, orders, rate)) << copies << ' ' << rate;
    }
  }
}

// Rows of a chain coupled in a ring, with random orders and one growing mode of a row beside them.
TEST(GrowingModes, OfManyRowsWithDifferentOrdersAreFound) {
  constexpr Eigen::Index size = 40;
  Vec orders(size);
  Matrix ring = Matrix::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    orders[i] = 0.3 + 0.65 * static_cast<double>(i * i % size) / static_cast<double>(size);
    ring(i, i) = -std::pow(10.0, static_cast<double>(i % 6));
    ring(i, (i + 1) % size) = 0.4 * ring(i, i);  // diagonally dominant: no mode grows
  }
  EXPECT_FALSE(grows_faster(ring, orders, 0.1));
  EXPECT_FALSE(grows_faster(ring, orders, 100.0));
  ring.row(7).setZero();
  ring(7, 7) = std::pow(5.0, orders[7]);
  EXPECT_TRUE(grows_faster(ring, orders, 4.0));
  EXPECT_FALSE(grows_faster(ring, orders, 6.0));
}

// u'' = -u, many times: on the imaginary axis, which is the edge of the region.
TEST(GrowingModes, AreNotUndampedOscillations) {
  for (const Eigen::Index copies : {1, 5, 20}) {
    const Matrix unit = Matrix::Identity(copies, copies);
    EXPECT_FALSE(grows_faster(-unit, Vec::Constant(copies, 2.0), 0.01)) << copies;
  }
}

// Second differences with 0 at both ends have the eigenvalues -4 c sin^2(k pi / (2 (n + 1))), and a shift
// adds to all. The norms suffice for so many rows.
TEST(GrowingModes, OfDiffusionAreThoseOfItsReaction) {
  constexpr Eigen::Index size = 2000;
  constexpr double coupling = 4e6;
  for (const double order : {0.4, 1.0, 1.7}) {
    for (const double reaction : {-1.0, 0.0, 9.0}) {
      SparseMatrix diffusion(size, size);
      for (Eigen::Index i = 0; i < size; ++i) {
        diffusion.insert(i, i) = reaction - 2.0 * coupling;
        if (i > 0) diffusion.insert(i, i - 1) = diffusion.insert(i - 1, i) = coupling;
      }
      const double fastest = reaction > 0.0 ? std::pow(reaction, 1.0 / order) : 0.0;
      EXPECT_FALSE(grows_faster(diffusion, order, 1.01 * fastest + 0.01)) << order << ' ' << reaction;
      if (reaction > 0.0) {
        EXPECT_TRUE(grows_faster(diffusion, order, 0.99 * fastest)) << order;
      }
    }
  }
}

// A ring in which each row drives the next: the eigenvalues are -2 + r, r^200 = 1, and no sum of a row tells
// that none is near the sector.
TEST(GrowingModes, OfARingAreThoseOfItsEigenvalues) {
  constexpr Eigen::Index size = 200;
  SparseMatrix ring(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    ring.insert(i, i) = -2.0;
    ring.insert(i, (i + 1) % size) = 1.0;
  }
  EXPECT_FALSE(grows_faster(ring, 1.5, 0.5));
  for (Eigen::Index i = 0; i < size; ++i) ring.coeffRef(i, i) = 0.5;
  EXPECT_TRUE(grows_faster(ring, 1.5, 1.0));
  EXPECT_FALSE(grows_faster(ring, 1.5, 1.01 * std::pow(1.5, 1.0 / 1.5)));
}

TEST(GrowingModes, OfAnOrderNextToZeroAreNotRuledOut) {
  EXPECT_TRUE(grows_faster(Matrix{{-1.0, 0.5}, {0.5, -1.5}}, Vec{{1.9, 1e-300}}, 0.1));
}

}  // namespace
}  // namespace fde::bench
