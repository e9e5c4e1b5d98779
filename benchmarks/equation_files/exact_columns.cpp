// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/exact_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "fdebench/benchmarks/equation_files/rounded_values.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde::bench {

namespace {

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

const NamedFormula* given(const EquationText& text, const std::string& column) {
  const auto found = std::ranges::find_if(
      text.exact, [&](const NamedFormula& one) { return without_blanks(one.name) == column; });
  return found == text.exact.end() ? nullptr : &*found;
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
    if (column.order == 0.0 && given(text, column.name) == nullptr) {
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

}  // namespace

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
