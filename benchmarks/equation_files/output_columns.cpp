// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/output_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench {
namespace {

// Reads the formulas of [columns], which may name other columns.
class ColumnFormulas {
 public:
  ColumnFormulas(const EquationSystem& system, FileFormulas& formulas)
      : system_(system), formulas_(formulas) {}

  Expression value(const ColumnText& column) {
    const auto known = values_.find(column.name);
    if (known != values_.end()) return known->second;
    if (!open_.insert(column.name).second)
      throw std::invalid_argument(fmt::format("{}: must not depend on itself", column.name));
    const Expression value = formulas_.read(column.formula, variables());
    return values_[column.name] = value;
  }

 private:
  FormulaVariables variables() {
    const auto rows = variables_of(system_, formulas_.pool());
    const auto derivative = [this, rows](std::size_t unknown, double order) {
      const auto& of = system_.unknowns[unknown];
      if (of.chain && same_order(of.chain->leading().order, order)) {
        if (!system_.earlier.values.empty())
          throw std::invalid_argument("D of the leading order: must not be a column of a file with delays");
        return system_.rows[of.last_row()];
      }
      return rows.resolve_unknown(unknown, order);
    };
    const auto other = [this](std::string_view name) -> std::optional<Expression> {
      const auto& columns = formulas_.text().columns;
      const auto found = std::ranges::find(columns, name, &ColumnText::name);
      return found == columns.end() ? std::nullopt : std::optional(value(*found));
    };
    return {.time = true, .resolve_unknown = derivative, .resolve_other = other};
  }

  const EquationSystem& system_;
  FileFormulas& formulas_;
  std::map<std::string, Expression> values_{};
  std::set<std::string> open_{};
};

// Recognises rows and their right-hand sides.
SystemColumn column_of(const std::string& name, Expression value, const EquationSystem& system,
                       const ExpressionPool& pool) {
  if (pool[value].operation == Operation::variable && pool[value].variable > 0) {
    const Eigen::Index row = pool[value].variable - 1;
    for (auto column : columns_of(system)) {
      if (column.row != row) continue;
      column.name = name;
      return column;
    }
  }
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto& unknown = system.unknowns[u];
    if (unknown.chain && system.rows[unknown.last_row()] == value)
      return {name, u, unknown.chain->leading().order, -1, value};
  }
  return {name, SystemColumn::no_unknown, 0.0, -1, value};
}

// The name and the formula of the column of an output.
std::pair<std::string, FormulaText> shown_formula(const OutputText& output) {
  if (output.weighted) return {output.weighted->name, output.weighted->value};
  return {output.name, {.text = output.name, .position = {}}};
}

bool is_shown(const SystemColumn& column, const UnknownText& unknown) {
  const auto& orders = unknown.quadrature_orders;
  return !unknown.is_implied && std::ranges::find(orders, column.order) == orders.end();
}

}  // namespace

std::vector<SystemColumn> output_columns(const EquationSystem& system, FileFormulas& formulas) {
  if (formulas.text().columns.empty()) {
    std::vector<SystemColumn> shown;
    for (const auto& column : columns_of(system)) {
      const auto& outputs = formulas.text().outputs;
      const auto output = std::ranges::find(outputs, column.name, &OutputText::state);
      if (output != outputs.end()) {
        const auto& [name, formula] = shown_formula(*output);
        const auto value = formulas.read(formula, variables_of(system, formulas.pool()));
        shown.push_back(column_of(name, value, system, formulas.pool()));
      } else if (is_shown(column, formulas.text().unknowns[column.unknown])) {
        shown.push_back(column);
      }
    }
    return shown;
  }
  ColumnFormulas values(system, formulas);
  std::vector<SystemColumn> columns;
  for (const auto& column : formulas.text().columns)
    columns.push_back(column_of(column.name, values.value(column), system, formulas.pool()));
  return columns;
}

Outputs outputs_of(const std::vector<SystemColumn>& columns, Eigen::Index rows, ExpressionPool& pool) {
  std::vector<std::string> names;
  std::vector<Eigen::Index> selected;
  std::vector<Expression> values;
  bool same = std::ssize(columns) == rows;
  for (const auto& column : columns) {
    same = same && column.row == std::ssize(names);
    names.push_back(column.name);
    selected.push_back(column.row);
    values.push_back(column.in_rows(pool));
  }
  if (same) return {names};
  if (std::ranges::find(selected, -1) == selected.end()) return select_components(names, selected);
  return {names, Program(pool, values, rows)};
}

}  // namespace fde::bench
