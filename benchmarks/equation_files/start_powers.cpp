// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/start_powers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/expressions/time_powers.hpp"

namespace fde::bench {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// A lower bound of the positive powers of an expression, and whether it is not 0 at t = 0.
struct Start {
  double positive = never;
  bool is_nonzero = false;
  [[nodiscard]] double first() const { return is_nonzero ? 0.0 : positive; }
};

Start start_of(Operation operation, const Start& a, const Start& b, const Start& c, bool is_nonzero) {
  const auto product = [&] { return std::min(a.first() + b.positive, a.positive + b.first()); };
  switch (operation) {
    case Operation::multiply:
      return {product(), is_nonzero};
    case Operation::divide:
      return {std::min(a.positive, a.first() + b.positive), is_nonzero};
    default:
      return {std::min({a.positive, b.positive, c.positive}), is_nonzero};
  }
}

// Of all rows, from the positive powers of the variables: t and those of the rows.
std::vector<double> firsts_of_rows(const EquationSystem& system, const ExpressionPool& pool,
                                   const std::vector<double>& values, const std::vector<double>& variables) {
  const auto start = [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
    const bool is_nonzero = values[static_cast<std::size_t>(e)] != 0.0;
    if (node.operation == Operation::variable)
      return Start{variables[static_cast<std::size_t>(node.variable)], is_nonzero};
    if (const auto power = power_of_time(pool, node)) return Start{*power, is_nonzero};
    return start_of(node.operation, parts(0), parts(1), parts(2), is_nonzero);
  };
  std::vector<double> firsts;
  for (const auto& row : values_from_parts(pool, system.rows, Start{}, start)) firsts.push_back(row.first());
  return firsts;
}

// The smallest positive power of each node of a chain, if the right-hand side of its unknown begins with
// `first`.
void set_nodes(const EquationSystem::Unknown& unknown, double first, std::vector<double>& variables) {
  const auto& chain = *unknown.chain;
  std::vector<double> powers{chain.leading().order + first};
  for (std::size_t k = 1; k < chain.initial().size(); ++k)
    if (chain.initial()[k] != 0.0) powers.push_back(static_cast<double>(k));
  for (std::size_t i = 0; i < chain.nodes().size(); ++i) {
    double& positive = variables[static_cast<std::size_t>(unknown.first) + i + 1];
    for (const double p : powers)
      if (p > chain.nodes()[i]) positive = std::min(positive, p - chain.nodes()[i]);
  }
}

// Starts from unknowns that do not move; the powers found decrease until nothing changes, as shortest paths
// do.
// For each unknown a lower bound of the powers of t in its right-hand side at t = 0: 0 if it is not 0 there,
// else the smallest power that can occur, from the first powers of the unknowns. `values`: those of the
// expressions at t = 0. Precondition: there are no algebraic rows, and the right-hand sides are smooth at the
// start apart from powers of t.
std::vector<double> first_powers(const EquationSystem& system, const ExpressionPool& pool,
                                 const std::vector<double>& values) {
  std::vector<double> variables(static_cast<std::size_t>(system.size()) + 1, never);
  variables.front() = 1.0;
  std::vector<double> firsts(system.unknowns.size(), never);
  for (Eigen::Index round = 0; round <= system.size(); ++round) {
    const auto of_rows = firsts_of_rows(system, pool, values, variables);
    const auto before = std::exchange(firsts, {});
    for (const auto& unknown : system.unknowns) {
      firsts.push_back(of_rows[unknown.last_row()]);
      set_nodes(unknown, firsts.back(), variables);
    }
    if (firsts == before) break;  // the variables follow from them
  }
  return firsts;
}

constexpr double range = 2.0;  // powers up to the order plus this count
// Of an unknown. Next to each other so many powers are no series, and they are computed again and again.
constexpr std::size_t most_powers = 10'000;

Vec initial_values(const EquationSystem& system) {
  Vec start(system.size());
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start[i] = system.components[static_cast<std::size_t>(i)].initial.front();
  return start;
}

// What the right-hand side of an unknown depends on, its own terms included.
struct Dependence {
  std::vector<int> linear, nonlinear;  // variables of rows, by whether the derivative is a constant
  std::vector<double> time{};          // powers of t
};

std::vector<Dependence> dependences(const EquationSystem& system, ExpressionPool& pool,
                                    const std::vector<std::set<double>>& powers) {
  std::vector<Dependence> all;
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto row = system.rows[system.unknowns[u].last_row()];
    auto& found = all.emplace_back();
    found.time.assign(powers[u].begin(), powers[u].end());
    for (const int variable : pool.variables_in(row)) {
      if (variable == 0) {
        found.time.push_back(1.0);
      } else {
        const bool is_linear = pool.variables_in(pool.derivative(row, variable)).empty();
        (is_linear ? found.linear : found.nonlinear).push_back(variable);
      }
    }
  }
  return all;
}

// The unknown and the node of the row of a variable.
struct Node {
  std::size_t unknown;
  double order;
};
Node node_of(const EquationSystem& system, int variable) {
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto place = variable - 1 - system.unknowns[u].first;
    if (place < system.unknowns[u].size())
      return {u, system.unknowns[u].chain->nodes()[static_cast<std::size_t>(place)]};
  }
  throw std::out_of_range("no such row");
}

// The positive powers of a node, from those of its unknown.
std::vector<double> powers_of(const Node& node, const std::vector<std::vector<double>>& powers) {
  std::vector<double> found;
  for (const double p : powers[node.unknown])
    if (p > node.order && !same_order(p, node.order)) found.push_back(p - node.order);
  return found;
}

// The sums of any numbers of these positive powers, up to `range`, 0 included; empty if there are too many.
std::vector<double> sums_of(std::vector<double> powers) {
  constexpr std::size_t most_work = 100 * most_powers;
  std::ranges::sort(powers);
  std::vector<double> sums{0.0};
  std::size_t work = 0;
  for (const double p : powers) {
    const auto next = std::ranges::lower_bound(sums, p - power_separation);
    if (p > range || (next != sums.end() && *next < p + power_separation)) continue;
    sums = power_lattice(sums, {p}, range);
    work += sums.size();
    if (sums.size() > most_powers || work > most_work) return {};
  }
  return sums;
}

// The powers of an unknown from those of all; nullopt if there are too many.
std::optional<std::vector<double>> next_powers(const EquationSystem& system, std::size_t u,
                                               const Dependence& on, double first,
                                               const std::vector<std::vector<double>>& powers) {
  const auto& chain = *system.unknowns[u].chain;
  const double order = chain.leading().order;
  std::vector<double> summands = on.time, start, own;
  for (const int variable : on.nonlinear) {
    const auto some = powers_of(node_of(system, variable), powers);
    summands.insert(summands.end(), some.begin(), some.end());
  }
  const auto sums = sums_of(std::move(summands));
  if (sums.empty()) return std::nullopt;
  for (const double s : sums)
    if (s > first || same_order(s, first)) start.push_back(order + s);
  for (std::size_t k = 1; k < chain.initial().size(); ++k)
    if (chain.initial()[k] != 0.0) start.push_back(static_cast<double>(k));
  for (const int variable : on.linear) {
    const auto node = node_of(system, variable);
    if (node.unknown == u) own.push_back(node.order);
    for (const double s : powers_of(node, powers)) start.push_back(order + s);
  }
  std::size_t count = 0;
  auto all = power_closure(std::move(start), order + range, [&](double p) {
    std::vector<double> following;
    if (++count > most_powers) return following;
    for (const double node : own)
      if (p > node && !same_order(p, node)) following.push_back(p - node + order);
    return following;
  });
  return count > most_powers ? std::nullopt : std::optional(std::move(all));
}

bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < power_separation; });
}

// The non-integer powers of t in each right-hand side; nullopt if one is otherwise not smooth.
std::optional<std::vector<std::set<double>>> all_time_powers(const EquationSystem& system,
                                                             const ExpressionPool& pool,
                                                             const std::vector<double>& values) {
  std::vector<std::set<double>> all;
  for (const auto& unknown : system.unknowns) {
    auto powers = time_powers(pool, system.rows[unknown.last_row()], values);
    if (!powers) return std::nullopt;
    all.push_back(std::move(*powers));
  }
  return all;
}

}  // namespace

void add_powers(const Chain& chain, const std::vector<double>& powers, Smoothness& smoothness) {
  for (const double node : chain.nodes()) {
    auto& of_node = smoothness.powers.emplace_back();
    for (const double p : powers) {
      const bool is_initial = chain.size() == 1 && is_integer_order(p) && p < chain.leading().order;
      if (p > node && !same_order(p, node) && !is_initial) of_node.push_back(p - node);
    }
  }
}

// Starts from the initial values alone; the powers grow until nothing changes.
Smoothness starting_powers(const EquationSystem& system, ExpressionPool& pool) {
  constexpr int most_rounds = 500;
  const auto& unknowns = system.unknowns;
  const auto values = values_of_parts(pool, system.rows, initial_values(system));
  const auto of_time = all_time_powers(system, pool, values);
  if (!of_time) return {};
  const auto first = first_powers(system, pool, values);
  const auto on = dependences(system, pool, *of_time);
  std::vector<std::vector<double>> powers(unknowns.size());
  bool changes = true;
  for (int round = 0; changes; ++round) {
    if (round == most_rounds) return {};
    changes = false;
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
      auto next = next_powers(system, u, on[u], first[u], powers);
      if (!next) return {};
      changes = changes || !are_same(*next, powers[u]);
      powers[u] = std::move(*next);
    }
  }
  Smoothness smoothness;
  for (std::size_t u = 0; u < unknowns.size(); ++u) add_powers(*unknowns[u].chain, powers[u], smoothness);
  return smoothness;
}

}  // namespace fde::bench
