// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/posed_equations.hpp"

#include <utility>

namespace fde::bench::mechanics {

int PosedEquations::add_row(const StateRow& row, double order, std::vector<double> initial) {
  rows.push_back(row);
  components.push_back({order, std::move(initial)});
  return static_cast<int>(rows.size());
}

Expressions in_state(const PosedEquations& equations, const Expressions& of, const Algebra& algebra) {
  return algebra.pool().substituted(of, [&](int variable) {
    return variable == 0 ? algebra.pool().variable(0)
                         : equations.columns[static_cast<std::size_t>(variable) - 1];
  });
}

ExpressionMatrix in_state(const PosedEquations& equations, ExpressionMatrix of, const Algebra& algebra) {
  of.entries = in_state(equations, of.entries, algebra);
  return of;
}

std::vector<int> add_memory_rows(PosedEquations& equations, const MechanicalSystem& system) {
  std::vector<int> variables;
  for (const auto& [coordinate, order] : system.memory) {
    const double whole = order < 1.0 ? 1.0 : 2.0;
    variables.push_back(
        order == 1.0 ? 0 : equations.add_row({RowKind::memory, coordinate, order}, whole - order, {0.0}));
  }
  return variables;
}

void append_memory_rates(PosedEquations& equations, const MechanicalSystem& system,
                         const Expressions& velocity, const Expressions& acceleration) {
  for (const auto& [coordinate, order] : system.memory) {
    if (order != 1.0) equations.rhs.push_back(order < 1.0 ? velocity[coordinate] : acceleration[coordinate]);
  }
}

Expressions columns_from(const Expressions& position, const Expressions& velocity,
                         const std::vector<int>& memory, const MechanicalSystem& system,
                         const Algebra& algebra) {
  Expressions columns = position;
  columns.insert(columns.end(), velocity.begin(), velocity.end());
  for (std::size_t k = 0; k < memory.size(); ++k) {
    columns.push_back(memory[k] == 0 ? velocity[system.memory[k].coordinate]
                                     : algebra.pool().variable(memory[k]));
  }
  return columns;
}

}  // namespace fde::bench::mechanics
