// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"

#include <fmt/format.h>

#include <utility>

namespace fde::bench::mechanics {

namespace {

bool is_above_one(const Dynamics& dynamics) {
  const auto orders = dynamics.constraint_orders();
  return !orders.empty() && *orders.rbegin() > 1.0;
}

PosedEquations posed_above_one(const Dynamics& dynamics, Formulation formulation) {
  if (formulation == Formulation::integrated) return integrated_above_one(dynamics);
  if (formulation == Formulation::multiplier) return multiplier_above_one(dynamics);
  return {.ill_posed_reason =
              fmt::format("formulation = {}: must be integrated or multiplier for alpha = {}: above 1 the "
                          "highest derivative is D^(1+alpha) q inside the reaction",
                          name_of(formulation), *dynamics.constraint_orders().rbegin())};
}

// P, by columns: the projections of the unit vectors.
ExpressionMatrix projector(const Dynamics& dynamics) {
  const auto& algebra = dynamics.algebra();
  const auto n = dynamics.system().size();
  ExpressionMatrix result(n, n, algebra.zero());
  for (std::size_t j = 0; j < n; ++j) {
    Expressions unit(n, algebra.zero());
    unit[j] = algebra.number(1.0);
    const auto projected = dynamics.projected(unit);
    for (std::size_t i = 0; i < n; ++i) result(i, j) = projected[i];
  }
  return result;
}

// P' v: the derivative of the projector along the motion, times v.
Expressions turned(const ExpressionMatrix& projector, const Dynamics& dynamics) {
  const auto& algebra = dynamics.algebra();
  const auto& system = dynamics.system();
  auto variables = system.q();
  variables.push_back(0);
  const auto velocity = algebra.variables(system.v());
  auto motion = velocity;
  motion.push_back(algebra.number(1.0));
  ExpressionMatrix rate = projector;
  rate.entries = algebra.product(algebra.jacobian(projector.entries, variables), motion);
  return algebra.product(rate, velocity);
}

}  // namespace

int PosedEquations::add_row(const StateRow& row, double order, std::vector<double> initial) {
  rows.push_back(row);
  components.push_back({order, std::move(initial)});
  return static_cast<int>(rows.size());
}

Expressions PosedEquations::add_rows(ExpressionPool& pool, StateRow row, double order, const Vec& initial) {
  Expressions variables;
  for (const double start : initial) {
    row.coordinate = variables.size();
    variables.push_back(pool.variable(add_row(row, order, {start})));
  }
  return variables;
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

std::vector<int> add_memory_rows(PosedEquations& equations, const MechanicalSystem& system, double highest) {
  std::vector<int> variables;
  for (const auto& [coordinate, order] : system.memory) {
    const bool has_row = order != 1.0 && order <= highest;
    const double whole = order < 1.0 ? 1.0 : 2.0;
    variables.push_back(
        has_row ? equations.add_row({RowKind::memory, coordinate, order}, whole - order, {0.0}) : 0);
  }
  return variables;
}

void append_memory_rates(PosedEquations& equations, const std::vector<int>& memory,
                         const MechanicalSystem& system, const Expressions& velocity,
                         const Expressions& acceleration) {
  for (std::size_t k = 0; k < memory.size(); ++k) {
    const auto& [coordinate, order] = system.memory[k];
    if (memory[k] != 0) equations.rhs.push_back((order < 1.0 ? velocity : acceleration)[coordinate]);
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

PosedEquations posed(const Dynamics& dynamics, const FormulationChoice& choice) {
  if (is_above_one(dynamics)) return posed_above_one(dynamics, choice.formulation);
  switch (choice.formulation) {
    case Formulation::integrated:
      return integrated_equations(dynamics);
    case Formulation::multiplier:
      return multiplier_equations(dynamics);
    case Formulation::acceleration:
    case Formulation::stabilised:
      break;
  }
  return acceleration_equations(dynamics, choice.kappa);
}

Formulation reference_formulation(const Dynamics& dynamics) {
  const bool above_one = is_above_one(dynamics);
  const bool is_integrated = above_one ? integrated_above_one(dynamics).ill_posed_reason.empty()
                                       : !dynamics.force_order_with_memory_rates();
  if (dynamics.is_affine() && is_integrated) return Formulation::integrated;
  const bool is_accelerated = !above_one && acceleration_equations(dynamics, 0.0).ill_posed_reason.empty();
  return is_accelerated ? Formulation::acceleration : Formulation::multiplier;
}

PosedEquations integrated_equations(const Dynamics& dynamics) {
  if (const auto order = dynamics.force_order_with_memory_rates()) {
    return {.ill_posed_reason =
                fmt::format("formulation = integrated: must be multiplier, acceleration or stabilised where "
                            "a force contains a "
                            "derivative of order {} beside one of an order below 1 in a constraint",
                            *order)};
  }
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  const auto projection = projector(dynamics);
  const Vec free_part = at_start(dynamics, algebra.product(projection, algebra.numbers(system.velocity)));
  PosedEquations equations;
  const auto position = equations.add_rows(pool, {RowKind::position}, 1.0, system.position);
  const auto free_velocity = equations.add_rows(pool, {RowKind::free_velocity}, 1.0, free_part);
  const auto memory = add_memory_rows(equations, system);
  const Expressions at_rest(system.size(), algebra.zero());
  equations.columns = columns_from(position, at_rest, memory, system, algebra);
  const auto now = in_state(equations, projection, algebra);
  const auto fixed = in_state(equations, dynamics.compensation(dynamics.constraint()), algebra);
  const auto velocity = algebra.sum(algebra.product(now, free_velocity), fixed);
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  const auto free = in_state(equations, dynamics.free_acceleration(), algebra);
  const auto turning = in_state(equations, turned(projection, dynamics), algebra);
  equations.rhs = velocity;
  equations.append(algebra.sum(algebra.product(now, free), turning));
  const auto acceleration =
      algebra.sum(free, in_state(equations, dynamics.compensation(dynamics.free_defect()), algebra));
  append_memory_rates(equations, memory, system, velocity, acceleration);
  return equations;
}

PosedEquations multiplier_equations(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  PosedEquations equations;
  const auto position = equations.add_rows(pool, {RowKind::position}, 1.0, system.position);
  const auto velocity = equations.add_rows(pool, {RowKind::velocity}, 1.0, system.velocity);
  const auto memory = add_memory_rows(equations, system);
  const auto lambda = equations.add_rows(pool, {RowKind::multiplier}, 0.0, initial_multiplier(dynamics));
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  const auto acceleration =
      algebra.sum(in_state(equations, dynamics.free_acceleration(), algebra),
                  algebra.product(in_state(equations, dynamics.reaction_matrix(), algebra), lambda));
  equations.rhs = velocity;
  equations.append(acceleration);
  append_memory_rates(equations, memory, system, velocity, acceleration);
  equations.append(in_state(equations, dynamics.constraint(), algebra));
  return equations;
}

}  // namespace fde::bench::mechanics
