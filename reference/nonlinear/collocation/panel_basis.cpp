// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/panel_basis.hpp"

#include <cmath>

namespace fde::reference {

namespace {

LongVec with_ends(const LongVec& nodes) {
  const bool ended = nodes[nodes.size() - 1] == 1.0L;
  LongVec all(nodes.size() + (ended ? 1 : 2));
  all[0] = 0.0L;
  all.segment(1, nodes.size()) = nodes;
  all[all.size() - 1] = 1.0L;
  return all;
}

}  // namespace

PanelBasis::PanelBasis(int count, PanelPoints kind)
    : gauss(kind == PanelPoints::radau ? gauss_radau(count) : gauss_jacobi(count, 0)) {
  const LongVec& x = gauss.nodes;
  dense_nodes = with_ends(x).cast<double>();
  dense_weights = barycentric_weights(with_ends(x)).cast<double>();
  nodes = x.cast<double>();
  weights = gauss.weights.cast<double>();
  targets = dense_nodes.tail(dense_nodes.size() - 1);
  at_targets = lagrange_matrix(x, with_ends(x).tail(targets.size())).cast<double>();
  left_half = lagrange_matrix(x, x / 2).cast<double>();
  right_half = lagrange_matrix(x, (x.array() + 1) / 2).cast<double>();
  legendre = legendre_analysis(gauss).cast<double>();
}

// s = x u turns the integral into x^order int_0^1 (1-u)^(order-1) l_j(x u) du, exact by a Gauss-Jacobi rule.
Matrix PanelBasis::integral(double order) const {
  const auto count = static_cast<int>(points());
  const auto exponent = static_cast<long double>(order);
  const GaussRule rule = gauss_jacobi(count / 2 + 1, exponent - 1);
  const LongVec upper = with_ends(gauss.nodes).tail(targets.size());
  Matrix table(upper.size(), count);
  for (Eigen::Index i = 0; i < upper.size(); ++i) {
    const long double factor = std::pow(upper[i], exponent) / std::tgamma(exponent);
    const LongMatrix values = lagrange_matrix(gauss.nodes, upper[i] * rule.nodes);
    table.row(i) = (factor * rule.weights.transpose() * values).cast<double>();
  }
  return table;
}

Vec PanelBasis::interpolate(const Matrix& values, double x) const {
  for (Eigen::Index j = 0; j < dense_nodes.size(); ++j) {
    if (x == dense_nodes[j]) {
      return values.row(j);
    }
  }
  const Vec share = dense_weights.array() / (x - dense_nodes.array());
  return values.transpose() * share / share.sum();
}

}  // namespace fde::reference
