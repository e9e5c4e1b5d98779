// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/file_smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/start_powers.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/schemes/problem/jacobian.hpp"
#include "fdebench/schemes/problem/linear_smoothness.hpp"

namespace fde::bench {
namespace {

using Unknown = EquationSystem::Unknown;

bool has_finite_derivatives_at_start(const Problem& problem) {
  return jacobian_at(problem, 0.0, taylor_part(problem, 0.0)).allFinite();
}

// The powers of t in [exact] above 0, one list an unknown; nullopt if one is no sum of
// powers.
std::optional<std::vector<std::vector<double>>> exact_powers(const EquationSystem& system,
                                                             FileFormulas& formulas) {
  std::vector<std::vector<double>> all;
  for (const auto& unknown : system.unknowns) {
    const auto& exact = formulas.text().exact;
    const auto given = std::ranges::find(exact, unknown.name, &NamedFormula::name);
    if (given == exact.end()) return std::nullopt;
    const auto terms = time_terms(formulas.read(given->formula, {}), formulas.pool());
    if (!terms) return std::nullopt;
    auto& powers = all.emplace_back();
    for (const auto& [coefficient, power, from] : *terms) {
      const auto size = formulas.pool().value(coefficient), p = formulas.pool().value(power);
      if (from || !size || !p) return std::nullopt;
      const auto exponent = static_cast<double>(*p);
      if (*size != 0.0L && exponent > 0.0) powers.push_back(exponent);
    }
    std::ranges::sort(powers);
    powers.erase(std::unique(powers.begin(), powers.end(), same_order), powers.end());
  }
  return all;
}

std::optional<Smoothness> exact_smoothness(const EquationSystem& system, const Problem& problem,
                                           FileFormulas& formulas) {
  if (formulas.text().exact.empty()) return std::nullopt;
  auto powers = exact_powers(system, formulas);
  if (!powers || !has_finite_derivatives_at_start(problem)) return std::nullopt;
  Smoothness smoothness;
  for (std::size_t u = 0; u < powers->size(); ++u)
    add_powers(*system.unknowns[u].chain, (*powers)[u], smoothness);
  return smoothness;
}

std::optional<Smoothness> series_smoothness(const EquationSystem& system, const Problem& problem,
                                            ExpressionPool& pool) {
  const bool has_chains =
      std::ranges::any_of(system.unknowns, [](const auto& one) { return one.size() != 1; });
  const auto* linear = std::get_if<DenseLinearPart>(&problem.derivatives);
  if (has_chains || linear == nullptr) return std::nullopt;
  std::vector<PowerLoad> loads;
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    const auto terms = time_terms(pool.without_variables(system.rows[i], 1), pool);
    if (!terms) return std::nullopt;
    for (const auto& [coefficient, power, from] : *terms) {
      const auto size = pool.value(coefficient), p = pool.value(power);
      if (from || !size || !p || *p < 0.0L) return std::nullopt;
      PowerLoad load{static_cast<double>(*p), Vec::Zero(system.size())};
      load.coefficients[static_cast<Eigen::Index>(i)] = static_cast<double>(*size);
      loads.push_back(std::move(load));
    }
  }
  return linear_smoothness(system.components, linear->matrix, loads);
}

// The last rows of chains that contain a sign or step of t alone, or t if the file declares jumps.
std::vector<Eigen::Index> jumping_rows(const EquationSystem& system, const ExpressionPool& pool) {
  std::vector<Eigen::Index> rows;
  for (const auto& unknown : system.unknowns) {
    const auto last = unknown.first + unknown.size() - 1;
    const auto row = system.rows[static_cast<std::size_t>(last)];
    const auto switches = pool.arguments({row}, {Operation::sign, Operation::step});
    const bool is_switched = std::ranges::any_of(
        switches, [&](Expression e) { return pool.depends_on(e, 0) && !pool.depends_on_unknowns(e); });
    if (is_switched || (!system.jumps.empty() && pool.depends_on(row, 0))) rows.push_back(last);
  }
  return rows;
}

}  // namespace

Smoothness file_smoothness(const EquationSystem& system, const Problem& problem, FileFormulas& formulas) {
  auto& pool = formulas.pool();
  if (std::ranges::any_of(system.unknowns, [](const Unknown& one) { return !one.chain; })) return {};
  auto smoothness = exact_smoothness(system, problem, formulas);
  if (!smoothness) smoothness = series_smoothness(system, problem, pool);
  if (!smoothness) smoothness = starting_powers(system, pool);
  if (!smoothness->powers.empty()) smoothness->jumps = jumping_rows(system, pool);
  return *smoothness;
}

}  // namespace fde::bench
