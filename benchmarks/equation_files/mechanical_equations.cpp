// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/mechanical_equations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdebench/benchmarks/equation_files/mechanical_file.hpp"
#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/benchmarks/mechanics/dynamics.hpp"

namespace fde::bench {
namespace {

using mechanics::Algebra;
using mechanics::Dynamics;
using mechanics::Expressions;

// The names of the variables of the columns, of the multipliers and of the parameters.
class Names {
 public:
  Names(const mechanics::MechanicalSystem& system, const FileFormulas& formulas)
      : system_(system), formulas_(formulas) {}

  [[nodiscard]] int multiplier(std::size_t constraint) const {
    return static_cast<int>(system_.column_count() + system_.memory.size() + constraint) + 1;
  }
  [[nodiscard]] std::string of_multiplier(std::size_t constraint) const {
    return system_.constraints.size() == 1 ? "lambda" : fmt::format("lambda{}", constraint + 1);
  }
  [[nodiscard]] std::string of(int variable) const {
    if (variable == 0) return "t";
    if (auto parameter = formulas_.parameter_name(variable); !parameter.empty()) return parameter;
    const auto n = system_.size(), column = static_cast<std::size_t>(variable) - 1;
    if (column < n) return system_.coordinates[column];
    if (column < 2 * n) return fmt::format("D({},1)", system_.coordinates[column - n]);
    if (column < system_.column_count()) {
      const auto& [coordinate, order] = system_.memory[column - 2 * n];
      return fmt::format("D({},{})", system_.coordinates[coordinate], formulas_.order_text(order));
    }
    return of_multiplier(column - system_.column_count() - system_.memory.size());
  }

 private:
  const mechanics::MechanicalSystem& system_;
  const FileFormulas& formulas_;
};

bool is_diagonal(const Dynamics& dynamics, std::size_t row) {
  for (std::size_t j = 0; j < dynamics.system().size(); ++j)
    if (j != row && !dynamics.algebra().is_zero(dynamics.metric()(row, j))) return false;
  return true;
}

bool depends_on_columns(const ExpressionPool& pool, Expression of,
                        const mechanics::MechanicalSystem& system) {
  for (int variable = 0; variable <= static_cast<int>(system.column_count()); ++variable)
    if (pool.depends_on(of, variable)) return true;
  return false;
}

// One row of G q'' = forces + R^T lambda where this row of G is a parameter, otherwise of q'' = G^-1 (...).
EquationFormula equation_of(const Dynamics& dynamics, const UnknownText& coordinate, std::size_t i,
                            const Names& names) {
  const auto& algebra = dynamics.algebra();
  const auto& pool = algebra.pool();
  Expressions lambda;
  for (std::size_t j = 0; j < dynamics.constraint().size(); ++j)
    lambda.push_back(algebra.pool().variable(names.multiplier(j)));
  const auto name = [&](int variable) { return names.of(variable); };
  const auto mass = dynamics.metric()(i, i);
  const bool own = is_diagonal(dynamics, i) && !depends_on_columns(pool, mass, dynamics.system());
  const auto reaction = algebra.product(
      own ? algebra.transposed(dynamics.reaction_directions()) : dynamics.reaction_matrix(), lambda)[i];
  const auto force = own ? dynamics.generalised_forces()[i] : dynamics.free_acceleration()[i];
  EquationFormula equation{.unknown = coordinate.name,
                           .terms = {{own ? formula_text(pool, mass, name) : "1", "2"}},
                           .rhs = formula_text(pool, algebra.sum(force, reaction), name),
                           .initial = {}};
  for (const auto& value : coordinate.initial) equation.initial.push_back(value.text);
  return equation;
}

}  // namespace

std::vector<EquationFormula> mechanical_equations(const EquationText& text) {
  const auto parameters = default_parameters(text);
  FileFormulas formulas(text, parameters, NumberStorage::values, FileFormulas::ParametersAs::variables);
  const auto file = read_mechanical_file(formulas);
  if (file.is_extremum) return {};
  const Names names(file.system, formulas);
  auto equations = with_positions(formulas, [&] {
    const Algebra algebra(formulas.pool());
    const Dynamics dynamics(file.system, algebra);
    std::vector<EquationFormula> of_coordinates;
    for (std::size_t i = 0; i < file.system.size(); ++i)
      of_coordinates.push_back(equation_of(dynamics, text.unknowns[i], i, names));
    return of_coordinates;
  });
  for (std::size_t j = 0; j < file.system.constraints.size(); ++j) {
    equations.push_back({.unknown = names.of_multiplier(j),
                         .terms = {{"1", "0"}},
                         .rhs = text.mechanics->constraints[j].text,
                         .initial = {"0"}});
  }
  for (const auto& equation : equations)
    if (equation.rhs.empty()) return {};
  return equations;
}

bool are_readable(const std::vector<EquationFormula>& equations) {
  constexpr std::size_t longest = 160;
  return !equations.empty() &&
         std::ranges::all_of(equations, [](const EquationFormula& one) { return one.rhs.size() <= longest; });
}

std::vector<DisplayEquation> mechanical_statements(const EquationText& text) {
  std::vector<DisplayEquation> statements{{"L", text.mechanics->lagrangian.text}};
  for (const auto& force : text.mechanics->forces)
    statements.push_back({fmt::format("F_{}", force.name), force.formula.text});
  for (const auto& constraint : text.mechanics->constraints) statements.push_back({constraint.text, "0"});
  return statements;
}

}  // namespace fde::bench
