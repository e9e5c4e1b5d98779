// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/start_powers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <set>

#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench {
namespace {

using Unknown = EquationSystem::Unknown;

constexpr double range = 2.0;        // powers up to the order plus this count
constexpr double most_powers = 1e5;  // limit of the work

// The values of expressions 0 ... last at t = 0 and the initial values.
std::vector<double> values_at_start(const EquationSystem& system, const ExpressionPool& pool,
                                    Expression last) {
  Vec start(system.size());
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start[i] = system.components[static_cast<std::size_t>(i)].initial.front();
  std::vector<Expression> every(static_cast<std::size_t>(last) + 1);
  std::iota(every.begin(), every.end(), Expression{0});
  std::vector<double> values(every.size());
  Program(pool, every, system.size()).evaluate(0.0, start, values);
  return values;
}

// The exponent p of an expression t^p or sqrt(t); integer powers are not stored as such.
std::optional<double> power_of_time(const ExpressionPool& pool, const ExpressionPool::Node& entry) {
  const bool of_time = entry.arguments[0] != ExpressionPool::none &&
                       pool[entry.arguments[0]].operation == Operation::variable &&
                       pool[entry.arguments[0]].variable == 0;
  if (!of_time) return std::nullopt;
  if (entry.operation == Operation::sqrt) return 0.5;
  if (entry.operation != Operation::power || pool[entry.arguments[1]].operation != Operation::number)
    return std::nullopt;
  const auto power = static_cast<double>(pool[entry.arguments[1]].value);
  return power > 0.0 ? std::optional(power) : std::nullopt;
}

// Whether an operation is smooth at the arguments a, b.
bool is_smooth(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::divide:
      return b != 0.0;
    case Operation::power:
    case Operation::log:
    case Operation::sqrt:
    case Operation::abs:
    case Operation::sign:
    case Operation::step:
      return a != 0.0;
    case Operation::asin:
    case Operation::acos:
      return std::abs(a) != 1.0;
    case Operation::atan2:
      return a != 0.0 || b != 0.0;
    case Operation::min:
    case Operation::max:
      return a != b;
    default:
      return true;
  }
}

// The non-integer powers of t in a right-hand side; nullopt if it is otherwise not smooth.
std::optional<std::set<double>> powers_in(const ExpressionPool& pool, Expression rhs,
                                          const std::vector<double>& values) {
  std::set<double> powers;
  const auto used = pool.subexpressions(rhs);
  for (Expression e = 0; e <= rhs; ++e) {
    const auto& entry = pool[e];
    if (!used[static_cast<std::size_t>(e)] || entry.arguments[0] == ExpressionPool::none) continue;
    if (const auto power = power_of_time(pool, entry)) {
      powers.insert(*power);
      continue;
    }
    const auto at = [&](std::size_t i) {
      return entry.arguments[i] == ExpressionPool::none
                 ? 0.0
                 : values[static_cast<std::size_t>(entry.arguments[i])];
    };
    if (!is_smooth(entry.operation, at(0), at(1)) && !pool.variables_in(e).empty()) return std::nullopt;
  }
  return powers;
}

// For each unknown, the variables in its equation, including its own terms.
std::vector<std::set<int>> variables_of(const EquationSystem& system, const ExpressionPool& pool) {
  std::vector<std::set<int>> variables;
  for (const auto& unknown : system.unknowns) {
    const auto last = static_cast<std::size_t>(unknown.first + unknown.size()) - 1;
    variables.push_back(pool.variables_in(system.rows[last]));
  }
  return variables;
}

// For each unknown, the unknowns that its equation depends on, directly or through others.
std::vector<std::set<std::size_t>> dependencies(const std::vector<Unknown>& unknowns,
                                                const std::vector<std::set<int>>& variables) {
  std::vector<std::set<std::size_t>> on(unknowns.size());
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    on[u].insert(u);
    for (std::size_t v = 0; v < unknowns.size(); ++v) {
      const auto next = variables[u].upper_bound(static_cast<int>(unknowns[v].first));
      if (next != variables[u].end() && *next <= unknowns[v].first + unknowns[v].size()) on[u].insert(v);
    }
  }
  for (std::size_t through = 0; through < on.size(); ++through) {
    for (auto& set : on)
      if (set.contains(through)) set.insert(on[through].begin(), on[through].end());
  }
  return on;
}

// The increments of powers due to an unknown: for each derivative D^a of it that occurs, a power p of the
// right-hand side gives p + order - a.
std::set<double> increments_of(const Unknown& unknown, const std::set<double>& derivatives) {
  std::set<double> increments;
  const auto& chain = *unknown.chain;
  for (const double a : derivatives) {
    increments.insert(chain.leading().order - a);
    for (std::size_t k = 1; k < chain.initial().size(); ++k) {
      const auto power = static_cast<double>(k);
      if (chain.initial()[k] != 0.0 && power > a && power >= std::ceil(a)) increments.insert(power - a);
    }
  }
  return increments;
}

// The increments of each unknown; nullopt if a right-hand side is not smooth at the start.
std::optional<std::vector<std::set<double>>> all_increments(const EquationSystem& system,
                                                            const ExpressionPool& pool,
                                                            const std::vector<std::set<int>>& variables) {
  const auto& unknowns = system.unknowns;
  const auto values = values_at_start(system, pool, std::ranges::max(system.rows));
  std::set<int> used;
  for (const auto& some : variables) used.insert(some.begin(), some.end());
  std::vector<std::set<double>> increments;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const auto powers = powers_in(pool, *unknowns[u].rhs, values);
    if (!powers) return std::nullopt;
    std::set<double> derivatives{0.0};
    for (Eigen::Index i = 0; i < unknowns[u].size(); ++i) {
      if (used.contains(static_cast<int>(unknowns[u].first + i) + 1))
        derivatives.insert(unknowns[u].chain->nodes()[static_cast<std::size_t>(i)]);
    }
    increments.push_back(increments_of(unknowns[u], derivatives));
    increments.back().insert(powers->begin(), powers->end());
    if (variables[u].contains(0)) increments.back().insert(1.0);
  }
  return increments;
}

// Appends the powers of the rows of a chain, from the powers of its unknown.
void add_powers(const Chain& chain, std::vector<double> powers, Smoothness& smoothness) {
  for (std::size_t k = 1; k < chain.initial().size(); ++k)
    if (chain.initial()[k] != 0.0) powers.push_back(static_cast<double>(k));
  std::ranges::sort(powers);
  for (const double node : chain.nodes()) {
    auto& of_node = smoothness.powers.emplace_back();
    for (const double p : powers)
      if (p > node && !same_order(p, node)) of_node.push_back(p - node);
  }
}

}  // namespace

Smoothness starting_powers(const EquationSystem& system, const ExpressionPool& pool) {
  const auto& unknowns = system.unknowns;
  if (std::ranges::any_of(unknowns, [](const Unknown& one) { return !one.chain; })) return {};
  const auto variables = variables_of(system, pool);
  const auto increments = all_increments(system, pool, variables);
  if (!increments) return {};
  const auto on = dependencies(unknowns, variables);
  Smoothness smoothness;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    std::set<double> steps;
    for (const auto v : on[u]) steps.insert((*increments)[v].begin(), (*increments)[v].end());
    const double order = unknowns[u].chain->leading().order;
    if (static_cast<double>(steps.size()) * range / *steps.begin() > most_powers) return {};
    add_powers(*unknowns[u].chain, power_lattice({order}, {steps.begin(), steps.end()}, order + range),
               smoothness);
    if (!system.jumps.empty() && variables[u].contains(0))
      smoothness.jumps.push_back(unknowns[u].first + unknowns[u].size() - 1);
  }
  return smoothness;
}

}  // namespace fde::bench
