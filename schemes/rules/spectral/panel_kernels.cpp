// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde {

namespace {

// D^node of sum_k initial[k] t^k / k!.
std::vector<IntegratedRow::Power> derivative_of_start(const std::vector<double>& initial, double node) {
  std::vector<IntegratedRow::Power> start;
  for (std::size_t k = 0; k < initial.size(); ++k) {
    const double power = static_cast<double>(k) - node;
    if (power >= 0.0 && initial[k] != 0.0) start.push_back({initial[k] / std::tgamma(power + 1.0), power});
  }
  return start;
}

}  // namespace

PanelKernels::PanelKernels(const PanelRule& rule, const IntegratedRows& integrated_rows) : rule_(rule) {
  for (const auto& row : integrated_rows.rows) {
    if (row.order == 0.0) {
      order_of_.push_back(-1);
      continue;
    }
    const auto found = std::ranges::find(orders_, row.order);
    order_of_.push_back(found - orders_.begin());
    if (found == orders_.end()) orders_.push_back(row.order);
  }
  const Vec beyond = rule.points.array() - 1.0;
  for (const double order : orders_)
    own_integrals_.emplace_back(kernel_moments(order, beyond, rule.size()) * rule.to_coefficients);
}

Vec PanelKernels::units(double width) const {
  Vec units(std::ssize(orders_));
  for (Eigen::Index g = 0; g < units.size(); ++g)
    units[g] = std::pow(width / 2.0, orders_[static_cast<std::size_t>(g)]);
  return units;
}

const std::vector<Matrix>& PanelKernels::integrals_on(const RelativePosition& position) {
  auto found = cache_.find(position);
  if (found == cache_.end()) found = cache_.emplace(position, compute_integrals(position)).first;
  return found->second;
}

std::vector<Matrix> PanelKernels::compute_integrals(const RelativePosition& position) const {
  const Vec beyond = (2.0 * position.gap + 1.0 + rule_.points.array()) / position.width;
  std::vector<Matrix> kernels;
  for (const double order : orders_) kernels.push_back(kernel_moments(order, beyond, rule_.size()));
  return kernels;
}

std::size_t PanelKernels::bytes() const {
  return sizeof(double) * (cache_.size() + 1) * orders_.size() *
         static_cast<std::size_t>(rule_.size() * rule_.size());
}

IntegratedRows::IntegratedRows(const Problem& problem)
    : rows(problem.components.size()), origin(Vec::Zero(problem.size())) {
  std::vector<bool> chained(rows.size(), false);
  for (const auto& equation : problem.equations) {
    const Chain chain = chain_of(problem, equation);
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      const auto row = static_cast<std::size_t>(chain.first_row() + i);
      const double node = chain.nodes()[static_cast<std::size_t>(i)];
      rows[row] = {unknown_count(), chain.leading().order - node, derivative_of_start(chain.initial(), node)};
      chained[row] = true;
    }
    rhs_indices.push_back(chain.first_row() + chain.size() - 1);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (chained[i]) continue;
    const auto& component = problem.components[i];
    rows[i] = {unknown_count(), component.order, {}};
    if (!is_algebraic(component)) rows[i].taylor_terms = derivative_of_start(component.initial, 0.0);
    rhs_indices.push_back(static_cast<Eigen::Index>(i));
  }
  if (!problem.increments.is_given()) return;
  origin = problem.increments.origin;
  for (auto& row : rows) std::erase_if(row.taylor_terms, [](const auto& term) { return term.power == 0.0; });
}

Vec IntegratedRows::taylor_part(double t) const {
  Vec value = Vec::Zero(row_count());
  for (Eigen::Index i = 0; i < row_count(); ++i) {
    for (const auto& [coefficient, power] : rows[static_cast<std::size_t>(i)].taylor_terms)
      value[i] += coefficient * (power == 0.0 ? 1.0 : power == 1.0 ? t : std::pow(t, power));
  }
  return value;
}

}  // namespace fde
