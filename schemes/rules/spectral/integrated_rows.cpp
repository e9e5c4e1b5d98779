// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/integrated_rows.hpp"

#include <cmath>

#include "fdebench/schemes/problem/chain_problem.hpp"
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
