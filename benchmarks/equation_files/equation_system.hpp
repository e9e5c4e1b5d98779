#pragma once

#include <optional>
#include <string>
#include <vector>

#include "equation_files/file_formulas.hpp"
#include "problem/chain.hpp"
#include "problem/problem.hpp"

namespace fde {

// The equations of a file with values of its parameters: the rows of a problem, their right-hand sides as
// expressions of t, variable 0, and y_i, variable i + 1.
struct EquationSystem {
  struct Unknown {
    std::string name;
    Eigen::Index first;               // row
    std::optional<Chain> chain;       // empty: an algebraic row
    std::optional<Expression> rhs{};  // of the file
    [[nodiscard]] Eigen::Index size() const { return chain ? chain->size() : 1; }
  };
  std::vector<Unknown> unknowns{};
  std::vector<Component> components{};
  std::vector<Expression> rows{};  // f_i
  double end = 1.0;
  std::vector<double> jumps{};

  [[nodiscard]] Eigen::Index size() const { return std::ssize(components); }
};

// Throws std::invalid_argument naming file, line and column of what is no equation of this kind.
EquationSystem read_system(FileFormulas& formulas);

// The unknowns in the order of the file, then the other nodes of their chains as D(x,0.5).
struct SystemColumn {
  std::string name;
  std::size_t unknown;
  double order;      // as a derivative of the unknown
  Eigen::Index row;  // of the problem
};
std::vector<SystemColumn> columns_of(const EquationSystem& system);

// Formulas of the columns: column c is variable c + 1.
FormulaVariables variables_of(const std::vector<SystemColumn>& columns, Expressions& all, bool time);

// The problem: f, its derivatives and its multi-term equations. Throws as read_system does where a
// derivative is not known.
Problem problem_of(const EquationSystem& system, FileFormulas& formulas);

}  // namespace fde
