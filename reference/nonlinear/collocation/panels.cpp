// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/panels.hpp"

#include <algorithm>
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

HistoryTerm::HistoryTerm(const Problem& problem, const PanelBasis& basis)
    : problem_(problem), basis_(basis), jumps_(Vec::Zero(problem.size())) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.component(i).order;
    if (order == 0.0) continue;
    auto kernel = std::ranges::find(kernels_, order, &Kernel::order);
    if (kernel == kernels_.end()) {
      kernel = kernels_.insert(kernel, {order, {}});
    }
    kernel->components.push_back(i);
  }
}

Matrix HistoryTerm::at_targets(const std::vector<Panel>& panels, double from, double to) const {
  const Vec offset = (to - from) * basis_.targets;
  Matrix sum = Matrix::Zero(offset.size(), problem_.size());
  // Distances t - s are sums of positive terms, not differences of times: accurate for s close to t.
  for (const Panel& source : panels) {
    add_panel(source, (offset.array() + (from - source.to)).matrix(), sum);
  }
  for (const Kernel& kernel : kernels_) {
    for (const Eigen::Index i : kernel.components) {
      sum.col(i) /= std::tgamma(kernel.order);
    }
  }
  for (Eigen::Index k = 0; k < offset.size(); ++k) {
    sum.row(k) += taylor_part(problem_, from + offset[k]) + jumps_;
  }
  if (panels.empty()) return sum;
  for (const auto i : algebraic_rows(problem_))
    sum.col(i).setConstant(panels.back().values.bottomRows<1>()[i]);
  return sum;
}

// gap: distances from the end of the source to the targets, increasing. Gauss quadrature is exact up to
// rounding at a distance of one source length; for nearer targets the source is bisected towards its end.
void HistoryTerm::add_panel(const Panel& source, const Vec& gap, Matrix& integral) const {
  const auto nearer_than = [&](double length) {
    return static_cast<Eigen::Index>(std::ranges::lower_bound(gap, length) - gap.begin());
  };
  double length = source.length();
  Eigen::Index near = nearer_than(length);
  const Eigen::Index far = gap.size() - near;
  add_piece(source.rhs, length, gap.tail(far), integral.bottomRows(far));
  Matrix rhs = source.rhs;
  while (near > 0) {
    length /= 2;
    add_piece(basis_.left_half * rhs, length, gap.head(near).array() + length, integral.topRows(near));
    rhs = basis_.right_half * rhs;
    const Eigen::Index nearest = nearer_than(length);
    add_piece(rhs, length, gap.segment(nearest, near - nearest),
              integral.middleRows(nearest, near - nearest));
    near = nearest;
  }
}

void HistoryTerm::add_piece(const Matrix& rhs, double length, const Vec& gap,
                            Eigen::Ref<Matrix> integral) const {
  if (gap.size() == 0) {
    return;
  }
  const Eigen::RowVectorXd back = length * (1.0 - basis_.nodes.array()).matrix().transpose();
  const Eigen::ArrayXXd log_distance = (gap.replicate(1, back.size()).rowwise() + back).array().log();
  const Matrix load = length * (basis_.weights.asDiagonal() * rhs);
  for (const Kernel& kernel : kernels_) {
    const Matrix power = ((kernel.order - 1.0) * log_distance).exp();
    for (const Eigen::Index i : kernel.components) {
      integral.col(i).noalias() += power * load.col(i);
    }
  }
}

}  // namespace fde::reference
