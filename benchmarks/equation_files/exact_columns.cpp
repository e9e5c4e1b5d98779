#include "fdebench/benchmarks/equation_files/exact_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "fdebench/benchmarks/equation_files/rounded_values.hpp"
#include "fdebench/benchmarks/equation_files/time_terms.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde {

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
    reject_at(text.file, one.place,
              fmt::format("exact {}: no such column; there are {}", one.name, fmt::join(names, ", ")));
  }
  for (const auto& column : columns) {
    if (column.order == 0.0 && given(text, column.name) == nullptr) {
      reject_at(text.file, text.exact.front().place,
                fmt::format("exact: has no {}, it must have every unknown", column.name));
    }
  }
}

Expression column_of(const SystemColumn& column, const std::vector<SystemColumn>& columns,
                     FileFormulas& formulas) {
  auto& all = formulas.all();
  if (const auto* known = given(formulas.text(), column.name)) return formulas.read(known->formula, {});
  const auto* unknown = given(formulas.text(), columns[column.unknown].name);
  auto value = formulas.read(unknown->formula, {});
  if (const auto terms = time_terms(value, all)) {
    if (const auto derivative = caputo_derivative(*terms, column.order, all)) return *derivative;
  }
  if (column.order == 1.0) {
    try {
      return all.derivative(value, 0);
    } catch (const std::invalid_argument& none) {
      formulas.reject(unknown->formula, none.what());
    }
  }
  reject_at(formulas.text().file, unknown->place,
            fmt::format("exact: has no \"{}\", it must have this column too, {} being no sum of powers of t",
                        column.name, unknown->name));
}

}  // namespace

Reference exact_columns(const EquationText& text, const Parameters& parameters,
                        const std::vector<SystemColumn>& columns) {
  require_columns(text, columns);
  FileFormulas formulas(text, parameters, NumberStorage::written);
  std::vector<Expression> values;
  for (const auto& column : columns) values.push_back(column_of(column, columns, formulas));
  const auto all = std::make_shared<const ExpressionPool>(std::move(formulas.all()));
  return closed_form([all, values](const auto& time) { return rounded_values(*all, values, time); });
}

}  // namespace fde
