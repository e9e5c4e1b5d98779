// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/expressions/formula_tokens.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {
namespace {

constexpr Range any_order{.low = 0.0, .high = 10.0};
constexpr double largest_single_order = 2.0;  // of a row

// Whether the text contains a name.
bool has_name(const FormulaText& formula) {
  return !is_decimal(formula.text) && std::ranges::any_of(formula.text, is_letter);
}

// Rejects t and unknowns in the coefficient or the order of a term.
void require_constant(const FormulaText& formula, std::string_view allowed, FileFormulas& formulas) {
  const auto is_unknown = [&](std::string_view name) {
    return std::ranges::find(formulas.text().unknowns, name, &UnknownText::name) !=
           formulas.text().unknowns.end();
  };
  const auto refuse = [&](std::string_view name) -> std::optional<Expression> {
    if (name != "t" && !is_unknown(name)) return std::nullopt;
    throw std::invalid_argument(fmt::format("{}: must not vary; {}", formula.text, allowed));
  };
  formulas.read(formula, {.time = false, .resolve_other = refuse});
}

// The order of a term; below 0 the message says which unknown of its own expresses it.
double order_of(const TermText& term, std::string_view unknown, FileFormulas& formulas) {
  const double order = formulas.constant(term.order, "order", any_number);
  if (any_order.contains(order)) return order;
  const std::string hint =
      order < 0.0 ? fmt::format(
                        "; the integral of order {0} of {1} is an unknown z of its own: D^{0} z = {1}, "
                        "z(0) = 0",
                        -order, unknown)
                  : "";
  formulas.reject(term.order, fmt::format("order = {}: must be {}{}", order, any_order.text(), hint));
}

// x'(0) may be listed where the order depends on parameters and is at most 1; there it must be 0.
void require_no_slope(const FormulaText& slope, const FormulaText& order, FileFormulas& formulas) {
  const double value = formulas.constant(slope, "initial", any_number);
  if (value == 0.0) return;
  const auto allowed = fmt::format("0 when {} is at most 1", order.text);
  const auto is_named = [&](const ParameterText& one) { return one.declared.name == slope.text; };
  if (std::ranges::any_of(formulas.text().parameters, is_named)) reject(slope.text, value, allowed);
  formulas.reject(slope, fmt::format("initial = {}: must be {}", value, allowed));
}

std::vector<double> initial_values(const UnknownText& unknown, const FormulaText& order_text, double order,
                                   FileFormulas& formulas) {
  const std::size_t needed = initial_count(order), given = unknown.initial.size(),
                    at_end = unknown.final.size();
  if (at_end > 0 && !(order > 1.0)) {
    reject_at(formulas.text().file, unknown.final.front().position,
              fmt::format("final: the order of {} is {}: must be above 1 for a value at the end",
                          unknown.name, order));
  }
  const bool has_slope = needed == 1 && given == 2 && has_name(order_text);
  if (given + at_end != needed && !has_slope) {
    const auto plural = [](std::size_t count) { return count == 1 ? "" : "s"; };
    reject_at(
        formulas.text().file, unknown.position,
        fmt::format("unknown {}: has {} initial value{}{}: must have {}{}, as its order is {}", unknown.name,
                    given, plural(given), at_end == 0 ? "" : fmt::format(" and {} at the end", at_end),
                    needed, at_end == 0 ? "" : " in all", order));
  }
  if (has_slope) require_no_slope(unknown.initial.back(), order_text, formulas);
  std::vector<double> values;
  for (std::size_t i = 0; i < std::min(given, needed); ++i)
    values.push_back(formulas.constant(unknown.initial[i], "initial", any_number));
  return values;
}

// Makes known what the sums of the coefficients of one order are exactly.
void add_sums(const UnknownText& text, const std::vector<Expression>& coefficients, FileFormulas& formulas) {
  auto& pool = formulas.pool();
  if (!pool.has_fractions()) return;
  std::map<double, std::pair<double, Expression>> sums;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const double order = formulas.constant(text.terms[k].order, "order", any_order),
                 value = formulas.constant_in_double(text.terms[k].coefficient, "coefficient", any_number);
    const auto [place, is_new] = sums.try_emplace(order, value, coefficients[k]);
    if (is_new) continue;
    auto& [sum, exact] = place->second;
    sum += value;
    exact = pool.make_expression(Operation::add, exact, coefficients[k]);
    pool.add_constant(sum, exact);
  }
}

// The unknown with its chain, starting at row `first`; without a chain if the row is algebraic.
EquationSystem::Unknown unknown_of(const UnknownText& text, Eigen::Index first, FileFormulas& formulas) {
  std::vector<Term> terms;
  EquationSystem::Unknown unknown{.name = text.name, .first = first, .chain = {}};
  const TermText* leading = nullptr;
  for (const auto& term : text.terms) {
    require_constant(term.coefficient,
                     "a coefficient that does is a factor, or on the right with its D(x, q)", formulas);
    require_constant(term.order, "orders that do are not supported", formulas);
    unknown.coefficients.push_back(formulas.read(term.coefficient, {.time = false}));
    terms.push_back({formulas.constant_in_double(term.coefficient, "coefficient", any_number),
                     order_of(term, text.name, formulas)});
    if (leading == nullptr || terms.back().order > terms.front().order) {
      std::swap(terms.front(), terms.back());
      leading = &text.terms[terms.size() - 1];
    }
  }
  add_sums(text, unknown.coefficients, formulas);
  const Term top = terms.front();
  if (top.order == 0.0 && text.may_be_algebraic) return unknown;
  if (top.order == 0.0)
    formulas.reject(leading->order, "the highest order is 0: must be above it; a row 0 = rhs is order = 0");
  if (text.factor && leading != text.terms.data())
    formulas.reject(*text.factor, "factor: the first term must be the leading one, without the factor");
  Term sum{0.0, top.order};
  for (const auto& term : terms)
    if (term.order == top.order) sum.coefficient += term.coefficient;
  if (sum.coefficient == 0.0) {
    formulas.reject(leading->coefficient,
                    "the coefficient of the highest order is 0: must be another number");
  }
  std::erase_if(terms, [&](const Term& term) { return term.order == top.order; });
  auto initial = initial_values(text, leading->order, top.order, formulas);
  if (!text.is_chain && top.order > largest_single_order) {
    formulas.reject(leading->order, fmt::format("order = {}: must be at most {} where chain is false",
                                                top.order, largest_single_order));
  }
  if (text.is_chain) {
    unknown.chain.emplace(sum, terms, std::move(initial), first);
  } else {
    unknown.chain = Chain::single_row(sum, std::move(initial), first);
  }
  return unknown;
}

// With a factor F the equation is (a + m F) D^top u + F (the other terms) = rhs, where a is the first
// coefficient and m the sum of the other ones of the leading order. Divided by (a + m F) / (a + m) it has a
// constant leading coefficient.
void add_scaled(const UnknownText& text, EquationSystem::Unknown& unknown, const FormulaVariables& variables,
                FileFormulas& formulas) {
  auto& pool = formulas.pool();
  unknown.rhs = formulas.read(text.rhs, variables);
  if (!text.factor || !unknown.chain) return;
  unknown.factor = formulas.read(*text.factor, variables);
  const double first = static_cast<double>(pool.value(unknown.coefficients.front()).value());
  const double sum = unknown.chain->leading().coefficient, others = sum - first;
  if (others == 0.0) return;
  const auto number = [&](double value) { return Operand{&pool, pool.number(value)}; };
  const Operand factor{&pool, *unknown.factor};
  const Operand scale = number(sum) / (number(first) + number(others) * factor);
  unknown.rhs = (scale * Operand{&pool, *unknown.rhs}).value;
  unknown.factor = (scale * factor).value;
}

// The index of this order, or else of one within rounding.
std::optional<std::size_t> nearest_order(const std::vector<double>& orders, double order) {
  auto found = std::ranges::find(orders, order);
  if (found == orders.end())
    found = std::ranges::find_if(orders, [&](double one) { return same_order(one, order); });
  if (found == orders.end()) return std::nullopt;
  return static_cast<std::size_t>(found - orders.begin());
}

// f_i = y_{i+1}; in the last row of a chain (rhs - factor sum_k c_k D^(a_k) u) / c.
void add_rows(const EquationSystem::Unknown& unknown, ExpressionPool& pool, std::vector<Expression>& rows) {
  if (!unknown.chain) {
    rows.push_back(*unknown.rhs);
    return;
  }
  const auto& chain = *unknown.chain;
  const auto number = [&](double value) { return Operand{&pool, pool.number(value)}; };
  Operand sum = number(0.0);
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const Operand row{&pool, pool.variable(static_cast<int>(unknown.first + i) + 1)};
    sum = sum + number(chain.coefficients()[i]) * row;
    if (i > 0) rows.push_back(row.value);
  }
  if (unknown.factor) sum = Operand{&pool, *unknown.factor} * sum;
  rows.push_back(((Operand{&pool, *unknown.rhs} - sum) / number(chain.leading().coefficient)).value);
}

// A jump at an unknown time, which only a run of its own could locate.
void require_no_earlier_switch(const EquationSystem& system, std::size_t u, FileFormulas& formulas) {
  const auto& pool = formulas.pool();
  const auto row = system.rows[system.unknowns[u].last_row()];
  for (const auto argument : pool.arguments({row}, jumps)) {
    const auto variables = pool.variables_in(argument);
    if (!variables.empty() && *variables.rbegin() > system.size()) {
      formulas.reject(formulas.text().unknowns[u].rhs,
                      "sign, step and floor of an earlier value are not supported, nor tables with jumps");
    }
  }
}

// The values of an unknown at the end.
std::vector<ValueAtEnd> values_at_end(const UnknownText& text, const EquationSystem::Unknown& unknown,
                                      const FormulaVariables& variables, FileFormulas& formulas) {
  std::vector<ValueAtEnd> values;
  for (const auto& [column, position, value] : text.final) {
    const auto row = row_named({.text = column, .position = position},
                               {.time = false, .resolve_unknown = variables.resolve_unknown}, formulas);
    if (row < unknown.first || row >= unknown.first + unknown.size()) {
      reject_at(formulas.text().file, position,
                fmt::format("final: {}: must be {} or one of its derivatives", column, text.name));
    }
    if (std::ranges::find(values, row, &ValueAtEnd::row) != values.end())
      reject_at(formulas.text().file, position, fmt::format("final: {}: must be given once", column));
    values.push_back({row, formulas.constant(value, "final", any_number)});
  }
  return values;
}

// The value of each row for t < 0 as a function of t; of rows that nothing looks back at the initial value.
std::vector<Expression> values_before(const EquationSystem& system, FileFormulas& formulas) {
  auto& pool = formulas.pool();
  std::vector<Expression> values;
  for (const auto& [order, initial, side] : system.components)
    values.push_back(pool.number(initial.empty() ? 0.0 : initial.front()));
  for (const auto& [row, lag] : system.earlier.values) {
    const auto u = unknown_of_row(system, row);
    const auto& unknown = system.unknowns[u];
    const auto& text = formulas.text().unknowns[u];
    if (!text.before) {
      reject_at(formulas.text().file, text.position,
                fmt::format("unknown {0}: must have the key before, its value for t < 0, as {0}(t - {1}) is "
                            "needed from there on",
                            text.name, lag));
    }
    const double order =
        unknown.chain ? unknown.chain->nodes()[static_cast<std::size_t>(row - unknown.first)] : 0.0;
    auto value = formulas.read(*text.before, {.is_before_start = true});
    if (!is_integer_order(order) && pool.value(value) != 0.0L) {
      formulas.reject(text.rhs, fmt::format("D({0}, {1})(t - {2}): must be of a whole order, others are not "
                                            "known before t = 0",
                                            text.name, order, lag));
    }
    for (double k = 0.0; k < order; ++k) value = pool.derivative(value, 0);
    if (!pool.arguments({value}, jumps).empty()) {
      formulas.reject(
          *text.before,
          "before: must not jump; sign, step and floor are not supported in it, nor tables with jumps");
    }
    values[static_cast<std::size_t>(row)] = value;
  }
  return values;
}

}  // namespace

std::size_t unknown_of_row(const EquationSystem& system, Eigen::Index row) {
  const auto after = std::ranges::upper_bound(system.unknowns, row, {}, &EquationSystem::Unknown::first);
  return static_cast<std::size_t>(after - system.unknowns.begin()) - 1;
}

Eigen::Index row_named(const FormulaText& name, const FormulaVariables& variables, FileFormulas& formulas) {
  const auto named = formulas.read(name, variables);
  return static_cast<Eigen::Index>(formulas.pool()[named].variable) - 1;  // t is variable 0
}

FormulaVariables variables_of(const EquationSystem& system, ExpressionPool& pool) {
  const auto node = [&](std::size_t of, double order) {
    const auto& unknown = system.unknowns[of];
    const auto nodes = unknown.chain ? unknown.chain->nodes() : std::vector{0.0};
    const auto row = nearest_order(nodes, order);
    if (row) return pool.variable(static_cast<int>(unknown.first + *row) + 1);
    const bool is_above = unknown.chain && order > unknown.chain->leading().order;
    throw std::invalid_argument(fmt::format(
        "D({}, {}): must be of an order of its chain, {}{}", unknown.name, order, fmt::join(nodes, ", "),
        is_above ? "; an order above those of the terms must be one of them" : ""));
  };
  return {.time = true, .resolve_unknown = node};
}

std::vector<double> declared_jumps(FileFormulas& formulas) {
  std::vector<double> jumps;
  for (const auto& jump : formulas.text().jumps)
    jumps.push_back(formulas.time_after_start(jump, "at", positive));
  return increasing(std::move(jumps));
}

EquationSystem read_system(FileFormulas& formulas) {
  const auto& text = formulas.text();
  if (text.unknowns.empty()) reject_at(text.file, {}, "unknown: all are left out, there must be one");
  EquationSystem system{.end = formulas.end(), .jumps = declared_jumps(formulas)};
  Eigen::Index first = 0;
  for (const auto& unknown : text.unknowns) {
    system.unknowns.push_back(unknown_of(unknown, first, formulas));
    first += system.unknowns.back().size();
  }
  auto variables = variables_of(system, formulas.pool());
  const auto earlier = [&, first](int row, double lag) {
    const EarlierValue asked{row, lag};
    auto& known = system.earlier.values;
    auto found = std::ranges::find(known, asked);
    if (found == known.end()) found = known.insert(known.end(), asked);
    return formulas.pool().variable(static_cast<int>(first + (found - known.begin())) + 1);
  };
  variables.earlier = [&, earlier](Expression of, double lag) {
    return formulas.pool().substituted({of}, [&](int variable) { return earlier(variable - 1, lag); })[0];
  };
  for (std::size_t u = 0; u < text.unknowns.size(); ++u) {
    auto& unknown = system.unknowns[u];
    add_scaled(text.unknowns[u], unknown, variables, formulas);
    if (unknown.chain) {
      std::ranges::copy(unknown.chain->components(), std::back_inserter(system.components));
    } else {
      const auto& order = text.unknowns[u].terms.front().order;
      system.components.push_back({0.0, initial_values(text.unknowns[u], order, 0.0, formulas)});
    }
    add_rows(unknown, formulas.pool(), system.rows);
    std::ranges::copy(values_at_end(text.unknowns[u], unknown, variables, formulas),
                      std::back_inserter(system.final));
  }
  for (const auto& unknown : text.unknowns)
    if (unknown.before) formulas.read(*unknown.before, {.is_before_start = true});
  if (system.earlier.values.empty()) return system;
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) require_no_earlier_switch(system, u, formulas);
  system.earlier.before = values_before(system, formulas);
  return system;
}

EquationSystem with_some_initial_values(EquationSystem system) {
  for (auto& unknown : system.unknowns) {
    if (!unknown.chain) continue;
    unknown.chain = unknown.chain->with_some_initial_values();
    std::ranges::copy(unknown.chain->components(), system.components.begin() + unknown.first);
  }
  return system;
}

EquationSystem at_start(EquationSystem system, ExpressionPool& pool) {
  const auto size = system.size();
  std::vector<Expression> values;
  for (const auto& [row, lag] : system.earlier.values) {
    const Operand time = Operand{&pool, pool.variable(0)} - Operand{&pool, pool.number(lag)};
    values.push_back(pool.substituted({system.earlier.before[static_cast<std::size_t>(row)]},
                                      [&](int /*t*/) { return time.value; })[0]);
  }
  const auto known = [&](int variable) {
    return variable <= size ? pool.variable(variable) : values[static_cast<std::size_t>(variable - size - 1)];
  };
  if (values.empty()) return system;
  system.rows = pool.substituted(system.rows, known);
  for (auto& unknown : system.unknowns) {
    if (unknown.rhs) unknown.rhs = pool.substituted({*unknown.rhs}, known)[0];
    if (unknown.factor) unknown.factor = pool.substituted({*unknown.factor}, known)[0];
  }
  system.earlier = {};
  return system;
}

std::vector<SystemColumn> columns_of(const EquationSystem& system) {
  std::vector<SystemColumn> columns, further;
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto& unknown = system.unknowns[u];
    const auto& chain = unknown.chain;
    columns.push_back({unknown.name, u, 0.0, unknown.first});
    for (Eigen::Index i = 1; chain && i < chain->size(); ++i) {
      const double order = chain->nodes()[static_cast<std::size_t>(i)];
      further.push_back({fmt::format("D({},{})", unknown.name, order), u, order, unknown.first + i});
    }
  }
  std::ranges::copy(further, std::back_inserter(columns));
  return columns;
}

FormulaVariables variables_of(const std::vector<SystemColumn>& columns, FileFormulas& formulas, bool time) {
  const auto column = [&](std::size_t unknown, double order) {
    std::vector<double> orders;
    for (const auto& one : columns) orders.push_back(one.unknown == unknown ? one.order : -1.0);
    if (const auto found = nearest_order(orders, order))
      return formulas.pool().variable(static_cast<int>(*found) + 1);
    throw std::invalid_argument(fmt::format("D({}, {}): must be a column of the scene",
                                            formulas.text().unknowns[unknown].name, order));
  };
  const auto output = [&](std::string_view name) -> std::optional<Expression> {
    const auto named = std::ranges::find(columns, name, &SystemColumn::name);
    if (named == columns.end()) return std::nullopt;
    return formulas.pool().variable(static_cast<int>(named - columns.begin()) + 1);
  };
  return {.time = time, .resolve_unknown = column, .resolve_output = output};
}

}  // namespace fde::bench
