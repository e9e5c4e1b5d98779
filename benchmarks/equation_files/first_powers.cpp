// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/first_powers.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

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
  const auto used = pool.subexpressions(system.rows);
  std::vector<Start> starts(used.size());
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (!used[e]) continue;
    const auto& entry = pool[static_cast<Expression>(e)];
    const bool is_nonzero = values[e] != 0.0;
    const auto at = [&](std::size_t i) {
      return entry.arguments[i] == ExpressionPool::none
                 ? Start{}
                 : starts[static_cast<std::size_t>(entry.arguments[i])];
    };
    if (entry.operation == Operation::variable) {
      starts[e] = {variables[static_cast<std::size_t>(entry.variable)], is_nonzero};
    } else if (const auto power = power_of_time(pool, entry)) {
      starts[e] = {*power, is_nonzero};
    } else {
      starts[e] = start_of(entry.operation, at(0), at(1), at(2), is_nonzero);
    }
  }
  std::vector<double> firsts;
  for (const auto row : system.rows) firsts.push_back(starts[static_cast<std::size_t>(row)].first());
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

}  // namespace

// Starts from unknowns that do not move; the powers found decrease until nothing changes, as shortest paths
// do.
std::vector<double> first_powers(const EquationSystem& system, const ExpressionPool& pool,
                                 const std::vector<double>& values) {
  std::vector<double> variables(static_cast<std::size_t>(system.size()) + 1, never);
  variables.front() = 1.0;
  std::vector<double> firsts(system.unknowns.size(), never);
  for (Eigen::Index round = 0; round <= system.size(); ++round) {
    const auto of_rows = firsts_of_rows(system, pool, values, variables);
    for (std::size_t u = 0; u < firsts.size(); ++u) {
      const auto& unknown = system.unknowns[u];
      firsts[u] = of_rows[static_cast<std::size_t>(unknown.first + unknown.size()) - 1];
      set_nodes(unknown, firsts[u], variables);
    }
  }
  return firsts;
}

}  // namespace fde::bench
