// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/singular_loads.hpp"

#include <utility>

#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"

namespace fde::bench {
namespace {

// A right-hand side as a sum: the loads c t^-p, and the rest.
struct SplitRow {
  std::vector<TimeTerm> singular{};
  Expression rest;
};

bool is_singular(const TimeTerm& term, const ExpressionPool& pool) {
  return !term.from && pool.value(term.power).value_or(0.0L) < 0.0L;
}

// Divides sums, and sums divided or multiplied by constants, into summands.
SplitRow split(Expression row, ExpressionPool& pool) {
  const auto is_constant = [&](Operand e) { return pool.value(e.value).has_value(); };
  SplitRow parts{.rest = pool.number(0)};
  // Summands and their factors.
  std::vector<std::pair<Expression, Operand>> open{{row, {&pool, pool.number(1)}}};
  while (!open.empty()) {
    const auto [part, factor] = open.back();
    open.pop_back();
    const auto [operation, of] = std::pair(pool[part].operation, pool[part].arguments);
    const Operand a{&pool, of[0]}, b{&pool, of[1]};
    if (operation == Operation::add || operation == Operation::subtract) {
      open.insert(open.end(), {{b.value, operation == Operation::add ? factor : -factor}, {a.value, factor}});
    } else if (operation == Operation::negate) {
      open.emplace_back(a.value, -factor);
    } else if (operation == Operation::divide && is_constant(b)) {
      open.emplace_back(a.value, factor / b);
    } else if (operation == Operation::multiply && (is_constant(a) || is_constant(b))) {
      open.emplace_back(is_constant(a) ? b.value : a.value, factor * (is_constant(a) ? a : b));
    } else {
      const auto terms = pool.depends_on_unknowns(part) ? std::nullopt : time_terms(part, pool);
      if (terms && terms->size() == 1 && is_singular(terms->front(), pool)) {
        const auto& [coefficient, power, from] = terms->front();
        parts.singular.push_back({(factor * Operand{&pool, coefficient}).value, power});
      } else {
        parts.rest = (Operand{&pool, parts.rest} + factor * Operand{&pool, part}).value;
      }
    }
  }
  return parts;
}

// J^order of the sum of c t^-p; nullopt unless every power of it is above 0.
std::optional<Expression> response(const std::vector<TimeTerm>& loads, double order, ExpressionPool& pool) {
  Operand sum{&pool, pool.number(0)};
  for (const auto& load : loads) {
    const auto p = pool.value(load.power).value();
    if (p <= -1.0L || p + order <= 0.0L) return std::nullopt;
    sum = sum + integral(load, {&pool, pool.number(order)});
  }
  return sum.value;
}

}  // namespace

std::optional<PosedProblem> without_singular_loads(const EquationSystem& system, const Problem& problem,
                                                   const std::vector<SystemColumn>& columns,
                                                   ExpressionPool& pool) {
  std::vector<Expression> rests, state;
  bool any = false;
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    auto parts = split(system.rows[i], pool);
    const auto moved = response(parts.singular, system.components[i].order, pool);
    if (!moved) return std::nullopt;
    any = any || !parts.singular.empty();
    rests.push_back(parts.singular.empty() ? system.rows[i] : parts.rest);
    state.push_back(pool.make_expression(Operation::add, pool.variable(static_cast<int>(i) + 1), *moved));
  }
  if (!any) return std::nullopt;
  const auto in_state = [&](const std::vector<Expression>& of) {
    return pool.substituted(of, [&](int variable) {
      return variable == 0 ? pool.variable(0) : state[static_cast<std::size_t>(variable) - 1];
    });
  };
  const auto size = system.size();
  PosedProblem posed{.problem = expression_problem(system.components, in_state(rests), system.end, pool)};
  if (problem.domain.margin) {
    posed.problem.domain = {
        .edge = problem.domain.edge,
        .margin = [margin = problem.domain.margin, to_y = Program(pool, state, size)](double t, In z) {
          Vec y(z.size());
          to_y(t, z, y);
          return margin(t, y);
        }};
  }
  std::vector<Expression> values;
  for (const auto& column : columns) {
    posed.outputs.names.push_back(column.name);
    values.push_back(column.in_rows(pool));
  }
  posed.outputs.evaluate = Program(pool, in_state(values), size);
  return posed;
}

}  // namespace fde::bench
