// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"

namespace fde::bench::mechanics {

PosedEquations multiplier_equations(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  PosedEquations equations;
  Expressions position, velocity, lambda;
  for (std::size_t i = 0; i < system.size(); ++i) {
    position.push_back(pool.variable(
        equations.add_row({RowKind::position, i}, 1.0, {system.position[static_cast<Eigen::Index>(i)]})));
  }
  for (std::size_t i = 0; i < system.size(); ++i) {
    velocity.push_back(pool.variable(
        equations.add_row({RowKind::velocity, i}, 1.0, {system.velocity[static_cast<Eigen::Index>(i)]})));
  }
  const auto memory = add_memory_rows(equations, system);
  for (const double guess : initial_multiplier(dynamics))
    lambda.push_back(pool.variable(equations.add_row({RowKind::multiplier}, 0.0, {guess})));
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  const auto acceleration =
      algebra.sum(in_state(equations, dynamics.free_acceleration(), algebra),
                  algebra.product(in_state(equations, dynamics.reaction_matrix(), algebra), lambda));
  equations.rhs = velocity;
  equations.rhs.insert(equations.rhs.end(), acceleration.begin(), acceleration.end());
  append_memory_rates(equations, system, velocity, acceleration);
  for (const auto e : in_state(equations, dynamics.constraint(), algebra)) equations.rhs.push_back(e);
  return equations;
}

}  // namespace fde::bench::mechanics
