// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {
namespace {

constexpr Range any_order{.low = 0.0, .high = 2.0};

std::vector<double> initial_values(const UnknownText& unknown, double order, FileFormulas& formulas) {
  const std::size_t needed = initial_count(order);
  if (unknown.initial.size() != needed) {
    reject_at(
        formulas.text().file, unknown.position,
        fmt::format("unknown {}: has {} initial value{}: must have {}, as its order is {}", unknown.name,
                    unknown.initial.size(), unknown.initial.size() == 1 ? "" : "s", needed, order));
  }
  std::vector<double> values;
  for (const auto& value : unknown.initial) values.push_back(formulas.constant(value, "initial", any_number));
  return values;
}

// The unknown with its chain, starting at row `first`; without a chain if the row is algebraic.
EquationSystem::Unknown unknown_of(const UnknownText& text, Eigen::Index first, FileFormulas& formulas) {
  std::vector<Term> terms;
  const TermText* leading = nullptr;
  for (const auto& [coefficient, order] : text.terms) {
    terms.push_back({formulas.constant(coefficient, "coefficient", any_number),
                     formulas.constant(order, "order", any_order)});
    if (leading == nullptr || terms.back().order > terms.front().order) {
      std::swap(terms.front(), terms.back());
      leading = &text.terms[terms.size() - 1];
    }
  }
  const Term top = terms.front();
  EquationSystem::Unknown unknown{.name = text.name, .first = first, .chain = {}};
  if (top.order == 0.0 && text.may_be_algebraic) return unknown;
  if (top.order == 0.0)
    formulas.reject(leading->order, "the highest order is 0: must be above it; a row 0 = rhs is order = 0");
  Term sum{0.0, top.order};
  for (const auto& term : terms)
    if (term.order == top.order) sum.coefficient += term.coefficient;
  if (sum.coefficient == 0.0) {
    formulas.reject(leading->coefficient,
                    "the coefficient of the highest order is 0: must be another number");
  }
  std::erase_if(terms, [&](const Term& term) { return term.order == top.order; });
  unknown.chain.emplace(sum, terms, initial_values(text, top.order, formulas), first);
  return unknown;
}

std::vector<double> jumps_of(FileFormulas& formulas) {
  std::vector<double> jumps;
  for (const auto& jump : formulas.text().jumps) jumps.push_back(formulas.constant(jump, "at", positive));
  std::ranges::sort(jumps);
  jumps.erase(std::unique(jumps.begin(), jumps.end()), jumps.end());
  return jumps;
}

// Maps D^order of an unknown to the variable of that node of its chain.
FormulaVariables variables_of(const EquationSystem& system, ExpressionPool& pool) {
  const auto row = [&](std::size_t of, double order) {
    const auto& unknown = system.unknowns[of];
    const auto nodes = unknown.chain ? unknown.chain->nodes() : std::vector{0.0};
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (same_order(nodes[i], order)) return pool.variable(static_cast<int>(unknown.first + i) + 1);
    throw std::invalid_argument(fmt::format("D({}, {}): must be of an order of its chain, {}", unknown.name,
                                            order, fmt::join(nodes, ", ")));
  };
  return {.time = true, .resolve_unknown = row};
}

// f_i = y_{i+1}; in the last row of a chain (rhs - sum_k c_k D^(a_k) u) / c.
void add_rows(const EquationSystem::Unknown& unknown, ExpressionPool& pool, std::vector<Expression>& rows) {
  if (!unknown.chain) {
    rows.push_back(*unknown.rhs);
    return;
  }
  const auto& chain = *unknown.chain;
  const auto row = [&](Eigen::Index i) { return pool.variable(static_cast<int>(unknown.first + i) + 1); };
  auto sum = pool.number(0);
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const auto weight = pool.number(fmt::format("{}", chain.coefficients()[i]));
    sum =
        pool.make_expression(Operation::add, sum, pool.make_expression(Operation::multiply, weight, row(i)));
    if (i > 0) rows.push_back(row(i));
  }
  const auto rest = pool.make_expression(Operation::subtract, *unknown.rhs, sum);
  rows.push_back(pool.make_expression(Operation::divide, rest,
                                      pool.number(fmt::format("{}", chain.leading().coefficient))));
}

}  // namespace

EquationSystem read_system(FileFormulas& formulas) {
  const auto& text = formulas.text();
  EquationSystem system{.end = formulas.constant(text.end, "end", valid_end_times),
                        .jumps = jumps_of(formulas)};
  Eigen::Index first = 0;
  for (const auto& unknown : text.unknowns) {
    system.unknowns.push_back(unknown_of(unknown, first, formulas));
    first += system.unknowns.back().size();
  }
  const auto variables = variables_of(system, formulas.pool());
  for (std::size_t u = 0; u < text.unknowns.size(); ++u) {
    auto& unknown = system.unknowns[u];
    unknown.rhs = formulas.read(text.unknowns[u].rhs, variables);
    if (unknown.chain) {
      std::ranges::copy(unknown.chain->components(), std::back_inserter(system.components));
    } else {
      system.components.push_back({0.0, initial_values(text.unknowns[u], 0.0, formulas)});
    }
    add_rows(unknown, formulas.pool(), system.rows);
  }
  return system;
}

std::vector<SystemColumn> columns_of(const EquationSystem& system) {
  std::vector<SystemColumn> columns, further;
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto& [name, first, chain, rhs] = system.unknowns[u];
    columns.push_back({name, u, 0.0, first});
    for (Eigen::Index i = 1; chain && i < chain->size(); ++i) {
      const double order = chain->nodes()[static_cast<std::size_t>(i)];
      further.push_back({fmt::format("D({},{})", name, order), u, order, first + i});
    }
  }
  std::ranges::copy(further, std::back_inserter(columns));
  return columns;
}

FormulaVariables variables_of(const std::vector<SystemColumn>& columns, ExpressionPool& pool, bool time) {
  const auto column = [&](std::size_t unknown, double order) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].unknown == unknown && same_order(columns[c].order, order))
        return pool.variable(static_cast<int>(c) + 1);
    }
    throw std::invalid_argument(
        fmt::format("D({}, {}): must be a column of the scene", columns[unknown].name, order));
  };
  return {.time = time, .resolve_unknown = column};
}

}  // namespace fde::bench
