// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/file_smoothness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/start_powers.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

namespace {

using Unknown = EquationSystem::Unknown;

bool has_finite_derivatives_at_start(const Problem& problem) {
  return jacobian_at(BoundProblem(problem).problem(), 0.0, taylor_part(problem, 0.0)).allFinite();
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
    powers = increasing(std::move(powers), same_order);
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

// The power of the breaking points that functions of t alone give a row: of a jump, also a declared one, a
// kink, or the samples of a spline.
std::optional<double> power_by_time(Expression row, bool has_declared_jumps, const ExpressionPool& pool) {
  const auto has = [&](bool (*is_one)(const ExpressionPool::Node& node)) {
    return std::ranges::any_of(pool.arguments({row}, is_one), [&](Expression e) {
      return pool.depends_on(e, 0) && !pool.depends_on_unknowns(e);
    });
  };
  constexpr double of_spline = 3.0;
  if (has(jumps) || (has_declared_jumps && pool.depends_on(row, 0))) return 0.0;
  if (has(has_kink)) return 1.0;
  if (has([](const ExpressionPool::Node& node) { return node.function != nullptr; })) return of_spline;
  return std::nullopt;
}

// The power of t with which y of this row leaves its values before t = 0: 0 where it jumps, 1 where y' does.
double power_of_departure(Eigen::Index row, const EquationSystem& system, const Smoothness& smoothness,
                          ExpressionPool& pool) {
  constexpr double rounding = 1e-12;
  const auto& initial = system.components[static_cast<std::size_t>(row)].initial;
  Expression before = system.earlier.before[static_cast<std::size_t>(row)];
  for (std::size_t k = 0; k < initial.size(); ++k) {
    const auto at_zero = pool.substituted({before}, [&](int /*t*/) { return pool.number(0); })[0];
    const auto value = static_cast<double>(pool.value(at_zero).value_or(std::nan("")));
    if (!(std::abs(value - initial[k]) <= rounding * (1.0 + std::abs(value)))) return static_cast<double>(k);
    before = pool.derivative(before, 0);
  }
  double power = std::numeric_limits<double>::infinity();
  for (const double p : smoothness.powers[static_cast<std::size_t>(row)]) {
    const bool is_compared = is_integer_order(p) && p < static_cast<double>(initial.size()) - 0.5;
    if (!is_compared) power = std::min(power, p);
  }
  return power;
}

// The breaking points of the last rows of chains: those of t alone, and one lag after the start.
std::vector<BreakingPoint> file_breaking_points(const EquationSystem& system, const Smoothness& smoothness,
                                                ExpressionPool& pool) {
  std::vector<BreakingPoint> all;
  for (const auto& unknown : system.unknowns) {
    const auto row = system.rows[unknown.last_row()];
    auto power =
        power_by_time(row, !system.jumps.empty(), pool).value_or(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < system.earlier.values.size(); ++k) {
      const auto& [of, lag] = system.earlier.values[k];
      if (lag < system.end && pool.depends_on(row, static_cast<int>(system.size() + k) + 1))
        power = std::min(power, power_of_departure(of, system, smoothness, pool));
    }
    if (std::isfinite(power)) all.push_back({static_cast<Eigen::Index>(unknown.last_row()), power});
  }
  return all;
}

struct OrderedLimit {
  double order;
  Discontinuity found;
};

// The limit of a term whose order is the parameter of this name; nullopt if the term is continuous in it.
std::optional<OrderedLimit> limit_of(const EquationSystem::Unknown& unknown, Expression coefficient,
                                     const Parameter& parameter, double order, const ExpressionPool& pool) {
  const auto& initial = unknown.chain->initial();
  if (order != std::floor(order) || order >= unknown.chain->leading().order) return std::nullopt;
  if (parameter.range.high <= order) return std::nullopt;  // continuous from below
  const auto k = static_cast<std::size_t>(order);
  if (pool.value(coefficient) == 0.0L || initial[k] == 0.0) return std::nullopt;
  const bool has_smaller = parameter.range.low < order;
  const auto derivative = unknown.name + std::string(k, '\'');
  return OrderedLimit{
      order,
      {parameter.name, fmt::format("D^{} {} tends to {} - {}(0){}", parameter.name, unknown.name, derivative,
                                   derivative, has_smaller ? " from above" : "")}};
}

}  // namespace

Smoothness file_smoothness(const EquationSystem& system, const Problem& problem, FileFormulas& formulas) {
  auto& pool = formulas.pool();
  const EquationSystem start = at_start(system, pool);
  if (std::ranges::any_of(start.unknowns, [](const Unknown& one) { return !one.chain; })) return {};
  auto smoothness = exact_smoothness(start, problem, formulas);
  if (!smoothness) smoothness = series_smoothness(start, problem, pool);
  if (!smoothness) smoothness = starting_powers(start, pool);
  if (!smoothness->powers.empty())
    smoothness->breaking_points = file_breaking_points(system, *smoothness, pool);
  return *smoothness;
}

std::vector<Discontinuity> file_discontinuities(const EquationSystem& system, FileFormulas& formulas) {
  std::vector<Discontinuity> all;
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto& unknown = system.unknowns[u];
    const auto& terms = formulas.text().unknowns[u].terms;
    std::vector<OrderedLimit> limits;
    for (std::size_t k = 0; unknown.chain && k < terms.size(); ++k) {
      for (const auto& parameter : formulas.text().parameters) {
        if (parameter.declared.name != terms[k].order.text) continue;
        const double order = formulas.constant(terms[k].order, "order", any_number);
        if (auto limit =
                limit_of(unknown, unknown.coefficients[k], parameter.declared, order, formulas.pool()))
          limits.push_back(std::move(*limit));
      }
    }
    std::ranges::stable_sort(limits, {}, &OrderedLimit::order);
    for (auto& limit : limits) all.push_back(std::move(limit.found));
  }
  return all;
}

}  // namespace fde::bench
