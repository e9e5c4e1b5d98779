// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/benchmarks/expressions/values_at_start.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"

namespace fde::bench {

namespace {

// The time as a formula counts it from the start, or D^order of an unknown.
std::string name_of(int variable, const EquationSystem& system, double start) {
  for (const auto& column : columns_of(system))
    if (column.row == variable - 1) return column.name;
  return start == 0.0 ? "t" : fmt::format("(t - {})", start);
}

// A violated constraint would require a jump of the unknowns at t = 0.
void require_start_on_constraints(const EquationSystem& system, const Problem& given,
                                  FileFormulas& formulas) {
  if (!system.final.empty()) return;  // the initial values are not known
  const BoundProblem bound(given);
  const Problem& problem = bound.problem();
  const auto row = inconsistent_initial_row(problem);
  if (!row) return;
  Vec f(problem.size());
  problem.rhs(0.0, taylor_part(problem, 0.0), f);
  formulas.reject(
      formulas.text().unknowns[unknown_of_row(system, *row)].rhs,
      fmt::format("is {:.6g} at t = {}: must be 0 with these initial values", f[*row], formulas.start()));
}

// A right-hand side that is no number at t = 0, nor next to it, is a mistake in the formula: the root of a
// negative number, or 0 times infinity.
void require_numbers_at_start(const EquationSystem& system, const Problem& problem, FileFormulas& formulas) {
  if (!system.final.empty()) return;
  constexpr double next_to_start = 1e-9;
  const auto& pool = formulas.pool();
  const auto rows = with_limits_at_start(at_start(system, formulas.pool()).rows, formulas.pool());
  const Vec start = taylor_part(problem, 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto part = not_a_number(rows[i], 0.0, start, pool);
    if (!part || !not_a_number(rows[i], next_to_start * system.end, start, pool)) continue;
    std::vector<std::string> values;
    for (const double y : start) values.push_back(fmt::format("{:.6g}", y));
    const auto row = static_cast<Eigen::Index>(i);
    formulas.reject(
        formulas.text().unknowns[unknown_of_row(system, row)].rhs,
        fmt::format("{} is not a number at t = {} with the initial values {}: must be one",
                    formula_text(pool, *part,
                                 [&](int variable) { return name_of(variable, system, formulas.start()); }),
                    formulas.start(), fmt::join(values, ", ")));
  }
}

// The values of rows at the end; empty: none is given.
std::function<void(In at_start, In at_end, Out residual)> conditions_of(const EquationSystem& system) {
  if (system.final.empty()) return {};
  return [values = system.final](In, In at_end, Out residual) {
    for (std::size_t k = 0; k < values.size(); ++k)
      residual[static_cast<Eigen::Index>(k)] = at_end[values[k].row] - values[k].value;
  };
}

std::string only_text(const Program& program) {
  const auto texts = program.texts();
  return texts.empty() ? "" : texts.front();
}

std::function<double(double t, In y)> factor_of(const EquationSystem::Unknown& unknown,
                                                const ExpressionPool& pool, Eigen::Index size) {
  if (!unknown.factor) return [](double, In) { return 1.0; };
  return Program(pool, {*unknown.factor}, size);
}

// The row that a key of `set` names.
Eigen::Index row_to_set(const NamedFormula& set, const EquationSystem& system, FileFormulas& formulas) {
  const FormulaText name{.text = set.name, .position = set.position};
  const auto row = row_named(name, variables_of(system, formulas.pool()), formulas);
  if (row < 0 || is_algebraic(system.components[static_cast<std::size_t>(row)])) {
    formulas.reject(
        name, fmt::format("set: {}: must be an unknown with a derivative, or a node of its chain", set.name));
  }
  return row;
}

Reset reset_of(const EventText& event, const EquationSystem& system, FileFormulas& formulas) {
  const auto variables = variables_of(system, formulas.pool());
  std::vector<Eigen::Index> rows;
  std::vector<Expression> values;
  for (const auto& set : event.set) {
    rows.push_back(row_to_set(set, system, formulas));
    values.push_back(formulas.read(set.formula, variables));
  }
  return {
      .value = Program(formulas.pool(), {formulas.read(event.zero, variables)}, system.size()),
      .crossing = event.crossing,
      .state = [rows, program = Program(formulas.pool(), values, system.size())](double t, In y, Out state) {
        Vec set(std::ssize(rows));
        program(t, y, set);
        state(rows) = set;
      }};
}

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

Problem problem_of(const EquationSystem& system, FileFormulas& formulas) {
  const auto size = system.size();
  auto& pool = formulas.pool();
  Problem problem = [&] {
    try {
      return expression_problem(system.components, system.rows, system.end, pool, system.earlier);
    } catch (const DerivativeError& none) {
      formulas.reject(formulas.text().unknowns[unknown_of_row(system, none.row)].rhs, none.what());
    }
  }();
  problem.conditions = conditions_of(system);
  require_numbers_at_start(system, problem, formulas);
  require_start_on_constraints(system, problem, formulas);
  for (const auto& event : formulas.text().events)
    if (!event.set.empty()) problem.resets.push_back(reset_of(event, system, formulas));
  if (!system.earlier.values.empty()) return problem;  // a force of t and y could not look back
  for (const auto& unknown : system.unknowns) {
    if (!unknown.chain || unknown.chain->size() == 1) continue;
    const auto& chain = *unknown.chain;
    const Program force(pool, with_limits_at_start({*unknown.rhs}, pool), size);
    problem.equations.push_back({.first_row = chain.first_row(),
                                 .leading = chain.leading(),
                                 .terms = chain.terms(),
                                 .force = force,
                                 .factor = factor_of(unknown, pool, size)});
    if (!unknown.factor) problem.equations.back().force_text = [force] { return only_text(force); };
  }
  return problem;
}

std::optional<PosedProblem> without_singular_loads(const EquationSystem& system, const Problem& problem,
                                                   const std::vector<SystemColumn>& columns,
                                                   ExpressionPool& pool) {
  if (!system.earlier.values.empty() || !system.final.empty()) return std::nullopt;
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
