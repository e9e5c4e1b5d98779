// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"

namespace fde::bench {
namespace {

struct Entry {
  Eigen::Index row, column;
  Expression value;
};

// Rejects the right-hand side whose derivative by a variable is not available.
[[noreturn]] void reject_derivative(const EquationSystem& system, FileFormulas& formulas, int variable,
                                    const std::invalid_argument& reason) {
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto& unknown = system.unknowns[u];
    for (Eigen::Index i = unknown.first; i < unknown.first + unknown.size(); ++i) {
      try {
        formulas.pool().derivative(system.rows[static_cast<std::size_t>(i)], variable);
      } catch (const std::invalid_argument& of_row) {
        formulas.reject(formulas.text().unknowns[u].rhs, of_row.what());
      }
    }
  }
  throw reason;
}

// The nonzero entries of df_i/dy_j, row by row.
std::vector<Entry> derivatives_of(const EquationSystem& system, FileFormulas& formulas) {
  std::vector<Entry> entries;
  auto& pool = formulas.pool();
  const auto zero = pool.number(0);
  for (Eigen::Index column = 0; column < system.size(); ++column) {
    const auto variable = static_cast<int>(column) + 1;
    try {
      const auto values = pool.derivatives(system.rows, variable);
      for (std::size_t row = 0; row < values.size(); ++row)
        if (values[row] != zero) entries.push_back({static_cast<Eigen::Index>(row), column, values[row]});
    } catch (const std::invalid_argument& none) {
      reject_derivative(system, formulas, variable, none);
    }
  }
  std::ranges::stable_sort(entries, {}, &Entry::row);
  return entries;
}

// The arguments of sign and step in the rows that depend on unknowns.
std::vector<Expression> switches_of(const EquationSystem& system, const ExpressionPool& pool) {
  std::vector<Expression> found;
  for (const auto argument : pool.arguments(system.rows, {Operation::sign, Operation::step}))
    if (pool.depends_on_unknowns(argument)) found.push_back(argument);
  return found;
}

// Whether a row has a kink or a jump in the unknowns; its derivative may be constant elsewhere.
bool piecewise(const EquationSystem& system, const ExpressionPool& pool) {
  const auto arguments = pool.arguments(
      system.rows, {Operation::abs, Operation::sign, Operation::step, Operation::min, Operation::max});
  return std::ranges::any_of(arguments, [&](Expression e) { return pool.depends_on_unknowns(e); });
}

// The value of an expression if it is constant, either as written or because its derivatives vanish: (y +
// 1)^2 - y^2 has a constant derivative.
std::optional<double> constant_of(Expression value, Eigen::Index size, ExpressionPool& pool) {
  constexpr Eigen::Index few = 12;
  if (const auto known = pool.value(value)) return static_cast<double>(*known);
  const auto zero = pool.number(0);
  // sign and step have derivative 0 but are not constant
  const bool jumps = !pool.arguments({value}, {Operation::sign, Operation::step}).empty();
  if (size > few || jumps) return std::nullopt;
  for (int variable = 0; variable <= size; ++variable) {
    const auto slope = pool.derivative(value, variable);
    if (slope != zero && pool.value(slope) != 0.0L) return std::nullopt;
  }
  const auto at_zero = pool.value(pool.without_variables(value, 0));
  if (!at_zero || !std::isfinite(static_cast<double>(*at_zero))) return std::nullopt;
  return static_cast<double>(*at_zero);
}

std::optional<Matrix> matrix_of(const std::vector<Entry>& entries, Eigen::Index size, ExpressionPool& pool) {
  Matrix matrix = Matrix::Zero(size, size);
  for (const auto& [row, column, value] : entries) {
    const auto known = constant_of(value, size, pool);
    if (!known || !std::isfinite(*known)) return std::nullopt;
    matrix(row, column) = *known;
  }
  return matrix;
}

// The program writes to the places of a matrix without gaps between its columns.
DenseJacobian jacobian_of(const std::vector<Entry>& entries, Eigen::Index size, const ExpressionPool& pool) {
  std::vector<Expression> values;
  std::vector<Eigen::Index> places;
  for (const auto& [row, column, value] : entries) {
    values.push_back(value);
    places.push_back(column * size + row);
  }
  const auto count = static_cast<std::size_t>(size * size);
  return {[size, count, has_zeros = entries.size() < count, program = Program(pool, values, places, size)](
              double t, In y, OutMatrix jacobian) {
    if (jacobian.outerStride() != size) {
      Matrix matrix = Matrix::Zero(size, size);
      program.evaluate(t, y, {matrix.data(), count});
      jacobian = matrix;
      return;
    }
    if (has_zeros) std::fill_n(jacobian.data(), count, 0.0);
    program.evaluate(t, y, {jacobian.data(), count});
  }};
}

// A violated constraint would require a jump of the unknowns at t = 0.
void require_start_on_constraints(const EquationSystem& system, const Problem& problem,
                                  const FileFormulas& formulas) {
  const auto row = inconsistent_initial_row(problem);
  if (!row) return;
  Vec f(problem.size());
  problem.rhs(0.0, taylor_part(problem, 0.0), f);
  const auto unknown = std::ranges::find(system.unknowns, *row, &EquationSystem::Unknown::first);
  const auto number = static_cast<std::size_t>(unknown - system.unknowns.begin());
  formulas.reject(formulas.text().unknowns[number].rhs,
                  fmt::format("is {:.6g} at t = 0: must be 0 with these initial values", f[*row]));
}

}  // namespace

Problem problem_of(const EquationSystem& system, FileFormulas& formulas) {
  const auto size = system.size();
  auto& pool = formulas.pool();
  Problem problem{.components = system.components, .end = system.end};
  problem.rhs = [program = Program(pool, system.rows, size)](double t, In y, Out f) {
    program.evaluate(t, y, {f.data(), static_cast<std::size_t>(f.size())});
  };
  for (const auto value : switches_of(system, pool))
    problem.switching_functions.emplace_back(Program(pool, {value}, size));
  const auto entries = derivatives_of(system, formulas);
  auto matrix = piecewise(system, pool) ? std::nullopt : matrix_of(entries, size, pool);
  if (matrix) {
    problem.derivatives = DenseLinearPart{std::move(*matrix)};
  } else {
    problem.derivatives = jacobian_of(entries, size, pool);
  }
  require_start_on_constraints(system, problem, formulas);
  for (const auto& unknown : system.unknowns) {
    if (!unknown.chain || unknown.chain->size() == 1) continue;
    const auto& chain = *unknown.chain;
    problem.equations.push_back({.first_row = chain.first_row(),
                                 .leading = chain.leading(),
                                 .terms = chain.terms(),
                                 .force = Program(pool, {*unknown.rhs}, size),
                                 .factor = [](double, In) { return 1.0; }});
  }
  return problem;
}

}  // namespace fde::bench
