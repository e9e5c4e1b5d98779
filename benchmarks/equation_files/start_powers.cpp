#include "equation_files/start_powers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include "equation_files/apply.hpp"

namespace fde {
namespace {

using Unknown = EquationSystem::Unknown;

// All expressions up to the last one at t = 0 and the initial values.
std::vector<double> values_at_start(const EquationSystem& system, const Expressions& all, Expression last) {
  std::vector<double> values(static_cast<std::size_t>(last) + 1);
  for (Expression e = 0; e <= last; ++e) {
    const auto& [operation, of, number, text, variable] = all[e];
    const auto at = [&](std::size_t i) {
      return of[i] == Expressions::none ? 0.0 : values[static_cast<std::size_t>(of[i])];
    };
    auto& value = values[static_cast<std::size_t>(e)];
    if (operation == Operation::number) {
      value = static_cast<double>(number);
    } else if (operation != Operation::variable) {
      value = apply<double>(operation, at(0), at(1), at(2));
    } else if (variable > 0) {
      const auto row = static_cast<std::size_t>(variable) - 1;
      if (row < system.components.size()) value = system.components[row].initial.front();
    }
  }
  return values;
}

// The p of t^p, where p is not whole.
std::optional<double> power_of_time(const Expressions& all, const Expressions::Entry& entry) {
  const bool of_time = entry.of[0] != Expressions::none &&
                       all[entry.of[0]].operation == Operation::variable && all[entry.of[0]].variable == 0;
  if (!of_time) return std::nullopt;
  if (entry.operation == Operation::sqrt) return 0.5;
  if (entry.operation != Operation::power || all[entry.of[1]].operation != Operation::number)
    return std::nullopt;
  const auto power = static_cast<double>(all[entry.of[1]].value);
  return power > 0.0 ? std::optional(power) : std::nullopt;
}

// Whether an operation is smooth at arguments a, b.
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

// The powers of t in a right-hand side beside whole ones; nothing: it is not smooth otherwise.
std::optional<std::set<double>> powers_in(const Expressions& all, Expression rhs,
                                          const std::vector<double>& values) {
  std::set<double> powers;
  const auto used = all.parts(rhs);
  for (Expression e = 0; e <= rhs; ++e) {
    const auto& entry = all[e];
    if (!used[static_cast<std::size_t>(e)] || entry.of[0] == Expressions::none) continue;
    if (const auto power = power_of_time(all, entry)) {
      powers.insert(*power);
      continue;
    }
    const auto at = [&](std::size_t i) {
      return entry.of[i] == Expressions::none ? 0.0 : values[static_cast<std::size_t>(entry.of[i])];
    };
    if (!is_smooth(entry.operation, at(0), at(1)) && all.depends_on_any(e, 0)) return std::nullopt;
  }
  return powers;
}

bool depends_on_row(const EquationSystem& system, const Expressions& all, const Unknown& unknown,
                    Eigen::Index row) {
  const auto last = static_cast<std::size_t>(unknown.first + unknown.size()) - 1;
  return all.depends_on(system.rows[last], static_cast<int>(row) + 1);
}

// The unknowns whose rows a right-hand side depends on, and those that these depend on.
std::vector<std::set<std::size_t>> dependences(const EquationSystem& system, const Expressions& all) {
  const auto& unknowns = system.unknowns;
  std::vector<std::set<std::size_t>> on(unknowns.size());
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    on[u].insert(u);
    for (std::size_t v = 0; v < unknowns.size(); ++v) {
      for (Eigen::Index i = 0; i < unknowns[v].size(); ++i)
        if (depends_on_row(system, all, unknowns[u], unknowns[v].first + i)) on[u].insert(v);
    }
  }
  for (std::size_t through = 0; through < on.size(); ++through) {
    for (auto& set : on)
      if (set.contains(through)) set.insert(on[through].begin(), on[through].end());
  }
  return on;
}

// By what the powers of those that depend on an unknown grow: with its powers p, those of D^a of it.
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

}  // namespace

Smoothness start_powers(const EquationSystem& system, const Expressions& all) {
  const auto& unknowns = system.unknowns;
  if (std::ranges::any_of(unknowns, [](const Unknown& one) { return !one.chain; })) return {};
  const auto values = values_at_start(system, all, std::ranges::max(system.rows));
  std::vector<std::set<double>> increments(unknowns.size());  // that each brings
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const auto powers = powers_in(all, *unknowns[u].rhs, values);
    if (!powers) return {};
    std::set<double> derivatives{0.0};
    for (Eigen::Index i = 0; i < unknowns[u].size(); ++i) {
      const auto used = [&](const Unknown& by) {
        return depends_on_row(system, all, by, unknowns[u].first + i);
      };
      if (std::ranges::any_of(unknowns, used))
        derivatives.insert(unknowns[u].chain->nodes()[static_cast<std::size_t>(i)]);
    }
    increments[u] = increments_of(unknowns[u], derivatives);
    increments[u].insert(powers->begin(), powers->end());
    if (all.depends_on(*unknowns[u].rhs, 0)) increments[u].insert(1.0);
  }
  const auto on = dependences(system, all);
  Smoothness smoothness;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    std::set<double> steps;
    for (const auto v : on[u]) steps.insert(increments[v].begin(), increments[v].end());
    const auto& chain = *unknowns[u].chain;
    const double order = chain.leading().order;
    auto powers = power_lattice({order}, {steps.begin(), steps.end()}, order + 2.0);
    for (std::size_t k = 1; k < chain.initial().size(); ++k)
      if (chain.initial()[k] != 0.0) powers.push_back(static_cast<double>(k));
    std::ranges::sort(powers);
    for (const double node : chain.nodes()) {
      auto& of_node = smoothness.powers.emplace_back();
      for (const double p : powers)
        if (p > node && !same_order(p, node)) of_node.push_back(p - node);
    }
  }
  if (!system.jumps.empty()) {
    for (const auto& unknown : unknowns)
      if (all.depends_on(*unknown.rhs, 0)) smoothness.jumps.push_back(unknown.first + unknown.size() - 1);
  }
  return smoothness;
}

}  // namespace fde
