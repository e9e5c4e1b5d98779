// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/file_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"
#include "fdebench/benchmarks/equation_files/rounded_values.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/closed_forms/free_pendulum.hpp"

namespace fde::bench {

namespace {

using Columns = std::vector<SystemColumn>;

// Rejects an exact column whose value at t = 0 differs from the initial value. A value that is not finite at
// t = 0 is not checked.
void require_exact_start(FileFormulas& formulas, const Columns& columns, const Problem& problem,
                         const reference::Reference& reference) {
  const auto& text = formulas.text();
  constexpr double rounding = 1e-9;
  const auto [value, bound] = reference.at(0.0);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].row < 0) continue;
    const auto& initial = problem.components[static_cast<std::size_t>(columns[c].row)].initial;
    const double at_start = value[static_cast<Eigen::Index>(c)];
    if (initial.empty() || !std::isfinite(at_start)) continue;
    if (std::abs(at_start - initial.front()) <= rounding * (1.0 + std::abs(initial.front()))) continue;
    reject_at(text.file, text.exact.front().position,
              fmt::format("exact: {} is {:.6g} at t = {}: must be {:.6g}, its initial value", columns[c].name,
                          at_start, formulas.start(), initial.front()));
  }
}

// Rejects an exact column that differs from its value at the end. A value that is not finite is not checked.
void require_exact_end(const EquationSystem& system, const Columns& columns, FileFormulas& formulas,
                       const reference::Reference& reference) {
  constexpr double rounding = 1e-9;
  if (system.final.empty()) return;
  const auto [value, bound] = reference.at(system.end);
  for (const auto& [row, given] : system.final) {
    const auto column = std::ranges::find(columns, row, &SystemColumn::row);
    if (column == columns.end()) continue;
    const double at_end = value[column - columns.begin()];
    if (!std::isfinite(at_end) || std::abs(at_end - given) <= rounding * (1.0 + std::abs(given))) continue;
    reject_at(formulas.text().file, formulas.text().exact.front().position,
              fmt::format("exact: {} is {:.6g} at t = {:.6g}: must be {:.6g}, its value at the end",
                          column->name, at_end, formulas.start() + system.end, given));
  }
}

// c, if the expression is c sin(x), x being the first row.
std::optional<double> factor_of_sine(Expression of, const ExpressionPool& pool) {
  const auto is_sine = [&](Expression e) {
    return pool[e].operation == Operation::sin &&
           pool[pool[e].arguments[0]].operation == Operation::variable &&
           pool[pool[e].arguments[0]].variable == 1;
  };
  if (is_sine(of)) return 1.0;
  const auto& [a, b, c] = pool[of].arguments;
  if (pool[of].operation == Operation::negate && is_sine(a)) return -1.0;
  if (pool[of].operation != Operation::multiply || !is_sine(b)) return std::nullopt;
  const auto factor = pool.value(a);
  return factor ? std::optional(static_cast<double>(*factor)) : std::nullopt;
}

// x'' = c sin x and no other term.
reference::Reference free_pendulum(const EquationSystem& system, const Columns& columns,
                                   const ExpressionPool& pool) {
  const auto& unknown = system.unknowns.front();
  const bool alone = system.unknowns.size() == 1 && unknown.chain && unknown.chain->terms().empty();
  if (!alone || unknown.factor || unknown.chain->leading().order != 2.0 ||
      unknown.chain->leading().coefficient != 1.0)
    return {};
  const bool state = columns.size() == 2 && columns[0].order == 0.0 && columns[1].order == 1.0;
  const auto factor = factor_of_sine(*unknown.rhs, pool);
  if (!factor || !state) return {};
  const auto& initial = unknown.chain->initial();
  if (!system.final.empty()) return {};
  return reference::pendulum_reference({-*factor, initial[0], initial[1]});
}

// In columns that are rows of the problem or their derivatives.
reference::Reference known_derivatives(const EquationSystem& system, const Problem& problem,
                                       const Columns& columns, FileFormulas& formulas) {
  const auto& text = formulas.text();
  if (!text.exact.empty()) {
    auto known = exact_columns(text, formulas.parameters(), columns_of(system), columns);
    require_exact_start(formulas, columns, problem, known);
    require_exact_end(system, columns, formulas, known);
    return known;
  }
  if (!system.earlier.values.empty() || !problem.resets.empty()) return {};
  if (auto known = linear_file_reference(text, formulas.parameters(), problem, columns)) return *known;
  return free_pendulum(system, columns, formulas.pool());
}

// Formulas of the rows, with the bounds of these and of their own rounding. Column c of `rows` is row
// shown[c]; the formulas depend on no other row.
reference::Reference formulas_of(const reference::Reference& rows, const Columns& shown, Eigen::Index size,
                                 const Columns& columns, ExpressionPool& pool) {
  using Value = reference::ConditionedValue<long double>;
  constexpr long double unit =
      reference::closed_form_rounding_factor * std::numeric_limits<long double>::epsilon();
  std::vector<Expression> values;
  for (const auto& column : columns) values.push_back(column.in_rows(pool));
  const auto at = [=, kept = std::make_shared<const ExpressionPool>(pool)](double t) {
    const auto [value, bound] = rows.at(t);
    std::vector<Value> known(static_cast<std::size_t>(size));
    for (std::size_t c = 0; c < shown.size(); ++c) {
      const auto i = static_cast<Eigen::Index>(c);
      known[static_cast<std::size_t>(shown[c].row)] = {value[i], bound[i] / unit};
    }
    const auto found = rounded_values(*kept, values, reference::from_shortest_decimal<long double>(t), known);
    reference::ReferenceValue result{Vec(std::ssize(found)), Vec(std::ssize(found))};
    for (std::size_t c = 0; c < found.size(); ++c) {
      const auto i = static_cast<Eigen::Index>(c);
      result.value[i] = static_cast<double>(found[c].value);
      const long double rounding = std::abs(found[c].value - static_cast<long double>(result.value[i]));
      result.bound[i] = static_cast<double>(unit * found[c].size + rounding);
    }
    return result;
  };
  return {.at = at, .evidence = rows.evidence, .zeros = rows.zeros};
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

const NamedFormula* given(const EquationText& text, const std::string& column) {
  const auto found = std::ranges::find_if(
      text.exact, [&](const NamedFormula& one) { return without_blanks(one.name) == column; });
  return found == text.exact.end() ? nullptr : &*found;
}

bool is_implied(const EquationText& text, const SystemColumn& column) {
  return text.unknowns[column.unknown].is_implied;
}

void require_columns(const EquationText& text, const std::vector<SystemColumn>& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.name);
  for (const auto& one : text.exact) {
    if (std::ranges::find(names, without_blanks(one.name)) != names.end()) continue;
    reject_at(text.file, one.position,
              fmt::format("exact {}: no such column; there are {}", one.name, fmt::join(names, ", ")));
  }
  for (const auto& column : columns) {
    if (column.order == 0.0 && !is_implied(text, column) && given(text, column.name) == nullptr) {
      reject_at(text.file, text.exact.front().position,
                fmt::format("exact: has no {}, it must have every unknown", column.name));
    }
  }
}

Expression column_of(const SystemColumn& column, FileFormulas& formulas) {
  auto& pool = formulas.pool();
  const auto& unknown_name = formulas.text().unknowns[column.unknown].name;
  const auto name = column.order == 0.0 ? unknown_name : fmt::format("D({},{})", unknown_name, column.order);
  if (const auto* known = given(formulas.text(), name)) return formulas.read(known->formula, {});
  const auto* unknown = given(formulas.text(), unknown_name);
  auto value = formulas.read(unknown->formula, {});
  if (const auto terms = time_terms(value, pool)) {
    if (const auto derivative = caputo_derivative(*terms, column.order, pool)) return *derivative;
  }
  if (column.order == 1.0) {
    try {
      return pool.derivative(value, 0);
    } catch (const std::invalid_argument& none) {
      formulas.reject(unknown->formula, none.what());
    }
  }
  reject_at(formulas.text().file, unknown->position,
            fmt::format("exact: has no \"{}\", it must have this column too, {} being no sum of powers of t",
                        name, unknown->name));
}

// The rows that [exact] gives. Rejects a column that contains an integral, of which [exact] says nothing.
Columns rows_without_implied(Columns rows, const Columns& columns, FileFormulas& formulas) {
  const auto& text = formulas.text();
  auto& pool = formulas.pool();
  for (const auto& row : rows) {
    if (!is_implied(text, row)) continue;
    for (const auto& column : columns) {
      if (!pool.depends_on(column.in_rows(pool), static_cast<int>(row.row) + 1)) continue;
      reject_at(
          text.file, text.exact.front().position,
          fmt::format("exact: does not determine the column {}, which contains a fractional integral or "
                      "derivative of a formula",
                      column.name));
    }
  }
  std::erase_if(rows, [&](const SystemColumn& row) { return is_implied(text, row); });
  return rows;
}

}  // namespace

reference::Reference file_reference(const EquationSystem& system, const Problem& problem,
                                    const Columns& columns, FileFormulas& formulas) {
  if (std::ranges::all_of(columns, &SystemColumn::is_derivative))
    return known_derivatives(system, problem, columns, formulas);
  auto rows = columns_of(system);
  std::ranges::sort(rows, {}, &SystemColumn::row);
  if (!formulas.text().exact.empty()) rows = rows_without_implied(rows, columns, formulas);
  const auto known = known_derivatives(system, problem, rows, formulas);
  return known.at ? formulas_of(known, rows, system.size(), columns, formulas.pool())
                  : reference::Reference{};
}

reference::Reference exact_columns(const EquationText& text, const Parameters& parameters,
                                   const std::vector<SystemColumn>& all,
                                   const std::vector<SystemColumn>& wanted) {
  require_columns(text, all);
  FileFormulas formulas(text, parameters, NumberStorage::decimals);
  std::vector<Expression> values;
  for (const auto& column : wanted) values.push_back(column_of(column, formulas));
  const auto pool = std::make_shared<const ExpressionPool>(std::move(formulas.pool()));
  return reference::closed_form(
      [pool, values](const auto& time) { return rounded_values(*pool, values, time); });
}

}  // namespace fde::bench
