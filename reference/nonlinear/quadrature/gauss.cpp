// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace fde::reference {

namespace {

long double legendre_p(int degree, long double x) {
  return degree < 0 ? 0.0L : boost::math::legendre_p(degree, 2 * x - 1);
}

// int_0^x P_k(2u-1) du = (P_(k+1) - P_(k-1)) / (2 (2k+1)), and x for k = 0.
long double legendre_integral(int degree, long double x) {
  return degree == 0 ? x
                     : (legendre_p(degree + 1, x) - legendre_p(degree - 1, x)) /
                           static_cast<long double>(2 * (2 * degree + 1));
}

// The zeros are close enough to zeros of a Chebyshev polynomial for Newton's method to find each.
Stages radau_nodes(int count) {
  constexpr int iterations = 12;
  Stages nodes(count);
  for (int k = 0; k < count; ++k) {
    const long double angle = std::numbers::pi_v<long double> *
                              static_cast<long double>(2 * (count - k) - 2) /
                              static_cast<long double>(2 * count - 1);
    long double x = std::cos(angle);
    for (int i = 0; i < iterations && k + 1 < count; ++i) {
      const long double value = boost::math::legendre_p(count, x) - boost::math::legendre_p(count - 1, x);
      const long double slope =
          boost::math::legendre_p_prime(count, x) - boost::math::legendre_p_prime(count - 1, x);
      x -= value / slope;
    }
    nodes[k] = k + 1 == count ? 1.0L : (1 + x) / 2;
  }
  return nodes;
}

}  // namespace

// Golub and Welsch (1969): nodes and weights from the symmetric tridiagonal matrix of the recurrence of the
// Jacobi polynomials for (1-u)^power on [-1, 1].
GaussRule gauss_jacobi(int count, long double power) {
  LongVec diagonal(count), beside(count - 1);
  diagonal[0] = -power / (power + 2);
  for (int k = 1; k < count; ++k) {
    const long double s = 2 * k + power;
    diagonal[k] = -power * power / (s * (s + 2));
    beside[k - 1] = 2 * k * (k + power) / (s * std::sqrt((s - 1) * (s + 1)));
  }
  Eigen::SelfAdjointEigenSolver<LongMatrix> eigen;
  eigen.computeFromTridiagonal(diagonal, beside);
  const LongVec first = eigen.eigenvectors().row(0);
  return {(eigen.eigenvalues().array() + 1) / 2, first.array().square() / (power + 1)};
}

// The nodes other than 1 are the nodes of the Gauss-Jacobi rule with weight 1 - x.
GaussRule gauss_radau(int count) {
  const GaussRule inner = gauss_jacobi(count - 1, 1);
  GaussRule rule{LongVec(count), LongVec(count)};
  rule.nodes << inner.nodes, 1.0L;
  rule.weights.head(count - 1) = inner.weights.array() / (1.0L - inner.nodes.array());
  rule.weights[count - 1] = 1.0L / (static_cast<long double>(count) * static_cast<long double>(count));
  return rule;
}

LongMatrix lagrange_matrix(const LongVec& nodes, const LongVec& points) {
  LongMatrix values = LongMatrix::Ones(points.size(), nodes.size());
  for (Eigen::Index j = 0; j < nodes.size(); ++j) {
    for (Eigen::Index k = 0; k < nodes.size(); ++k) {
      if (k != j) {
        values.col(j).array() *= (points.array() - nodes[k]) / (nodes[j] - nodes[k]);
      }
    }
  }
  return values;
}

LongMatrix legendre_analysis(const GaussRule& rule) {
  const Eigen::Index count = rule.nodes.size();
  const LongVec u = 2 * rule.nodes.array() - 1;
  LongMatrix values(count, count);  // row k: P_k at the nodes
  values.row(0).setOnes();
  if (count > 1) {
    values.row(1) = u;
  }
  for (Eigen::Index k = 1; k + 1 < count; ++k) {
    const auto order = static_cast<long double>(k);
    values.row(k + 1) = ((2 * order + 1) * u.transpose().array() * values.row(k).array() -
                         order * values.row(k - 1).array()) /
                        (order + 1);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    values.row(k).array() *= static_cast<long double>(2 * k + 1) * rule.weights.transpose().array();
  }
  return values;
}

LongVec barycentric_weights(const LongVec& nodes) {
  LongVec weights = LongVec::Ones(nodes.size());
  for (Eigen::Index j = 0; j < nodes.size(); ++j) {
    for (Eigen::Index k = 0; k < nodes.size(); ++k) {
      if (k != j) {
        weights[j] /= nodes[j] - nodes[k];
      }
    }
  }
  return weights;
}

RadauRule::RadauRule(int stages) {
  if (stages < 1 || stages > max_stages) {
    throw std::invalid_argument("Radau method: stages = " + std::to_string(stages) + ": must be in [1, " +
                                std::to_string(max_stages) + "]");
  }
  nodes = radau_nodes(stages);
  StageMatrix values(stages, stages), integrals(stages, stages), dense(stages + 1, stages + 1);
  for (int k = 0; k <= stages; ++k) {
    dense(0, k) = legendre_p(k, 0.0L);
    for (int i = 0; i < stages; ++i) {
      dense(i + 1, k) = legendre_p(k, nodes[i]);
      if (k < stages) {
        values(i, k) = legendre_p(k, nodes[i]);
        integrals(i, k) = legendre_integral(k, nodes[i]);
      }
    }
  }
  const StageMatrix coefficients = values.partialPivLu().inverse();
  integral = integrals * coefficients;
  at_nodes = coefficients.cast<double>();
  with_start = StageMatrix(dense.partialPivLu().inverse()).cast<double>();
}

}  // namespace fde::reference
