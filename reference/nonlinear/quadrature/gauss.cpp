// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace fde::reference {

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

}  // namespace fde::reference
