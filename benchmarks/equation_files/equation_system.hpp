// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// The value of a row at the end.
struct ValueAtEnd {
  Eigen::Index row;
  double value;
};

// The equations of a file for given values of its parameters: the rows of a problem, with right-hand sides as
// expressions of t (variable 0), y_i (variable i + 1) and, with delays, earlier values.
struct EquationSystem {
  struct Unknown {
    std::string name;
    Eigen::Index first;                      // first row
    std::optional<Chain> chain;              // nullopt: an algebraic row
    std::vector<Expression> coefficients{};  // of the terms, in the order of the file
    std::optional<Expression> rhs{};     // as in the file; divided by (a + m factor) / (a + m) if there is a
                                         // factor, a and m being those of the leading order (add_scaled)
    std::optional<Expression> factor{};  // of the terms that are not leading, divided likewise
    [[nodiscard]] Eigen::Index size() const { return chain ? chain->size() : 1; }
    [[nodiscard]] std::size_t last_row() const { return static_cast<std::size_t>(first + size()) - 1; }
  };
  std::vector<Unknown> unknowns{};
  std::vector<Component> components{};
  std::vector<Expression> rows{};   // f_i
  std::vector<ValueAtEnd> final{};  // as many as there are unknown initial values
  double end = 1.0;
  std::vector<double> jumps{};
  EarlierValues earlier{};

  [[nodiscard]] Eigen::Index size() const { return std::ssize(components); }
};

// Throws std::invalid_argument naming file, line and column if an equation is not of this kind.
EquationSystem read_system(FileFormulas& formulas);

// The system with 1 for each unknown initial value, as with_some_initial_values(problem).
EquationSystem with_some_initial_values(EquationSystem system);

// The index of the unknown to which this row belongs.
std::size_t unknown_of_row(const EquationSystem& system, Eigen::Index row);

// Variables for formulas in the rows: row i is variable i + 1, D^order of an unknown that node of its chain.
FormulaVariables variables_of(const EquationSystem& system, ExpressionPool& pool);

// The row that a formula names, as x or D(x, 1); -1: it is no row.
Eigen::Index row_named(const FormulaText& name, const FormulaVariables& variables, FileFormulas& formulas);

// The system up to the shortest lag, with the given values before t = 0 in place of earlier values.
EquationSystem at_start(EquationSystem system, ExpressionPool& pool);

// The times of [[jump]], in increasing order.
std::vector<double> declared_jumps(FileFormulas& formulas);

// The columns: the unknowns in the order of the file, then the other nodes of their chains, named D(x,0.5).
struct SystemColumn {
  static constexpr std::size_t no_unknown = static_cast<std::size_t>(-1);

  std::string name;
  std::size_t unknown;                // no_unknown: a formula of several
  double order;                       // as a derivative of the unknown
  Eigen::Index row;                   // row of the problem; -1: the column is `value`
  std::optional<Expression> value{};  // of t and the rows

  [[nodiscard]] bool is_derivative() const { return unknown != no_unknown; }
  [[nodiscard]] Expression in_rows(ExpressionPool& pool) const {
    return value ? *value : pool.variable(static_cast<int>(row) + 1);
  }
};
std::vector<SystemColumn> columns_of(const EquationSystem& system);

// Variables for formulas in the columns: column c is variable c + 1; `time`: whether t is allowed.
FormulaVariables variables_of(const std::vector<SystemColumn>& columns, FileFormulas& formulas, bool time);

// The problem: f, its derivatives and its multi-term equations. Throws as read_system does if a derivative is
// not available or an algebraic row does not hold at t = 0.
Problem problem_of(const EquationSystem& system, FileFormulas& formulas);

}  // namespace fde::bench
