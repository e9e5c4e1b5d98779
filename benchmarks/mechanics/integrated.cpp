// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"

namespace fde::bench::mechanics {
namespace {

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
  Expressions velocity;
  for (const int v : system.v()) velocity.push_back(algebra.pool().variable(v));
  auto motion = velocity;
  motion.push_back(algebra.number(1.0));
  ExpressionMatrix rate = projector;
  rate.entries = algebra.product(algebra.jacobian(projector.entries, variables), motion);
  return algebra.product(rate, velocity);
}

}  // namespace

PosedEquations integrated_equations(const Dynamics& dynamics) {
  if (const auto order = dynamics.force_order_with_memory_rates())
    return {.ill_posed_reason = refused_as_memory_rate(*order)};
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  const auto projection = projector(dynamics);
  Expressions start;
  for (const double v : system.velocity) start.push_back(algebra.number(v));
  const Vec free_part = at_start(dynamics, algebra.product(projection, start));
  PosedEquations equations;
  Expressions position, free_velocity;
  for (std::size_t i = 0; i < system.size(); ++i) {
    position.push_back(pool.variable(
        equations.add_row({RowKind::position, i}, 1.0, {system.position[static_cast<Eigen::Index>(i)]})));
  }
  for (std::size_t i = 0; i < system.size(); ++i) {
    free_velocity.push_back(pool.variable(
        equations.add_row({RowKind::free_velocity, i}, 1.0, {free_part[static_cast<Eigen::Index>(i)]})));
  }
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
  for (const auto e : algebra.sum(algebra.product(now, free), turning)) equations.rhs.push_back(e);
  const auto acceleration =
      algebra.sum(free, in_state(equations, dynamics.compensation(dynamics.free_defect()), algebra));
  append_memory_rates(equations, system, velocity, acceleration);
  return equations;
}

}  // namespace fde::bench::mechanics
