// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/dynamics.hpp"

#include <algorithm>

namespace fde::bench::mechanics {
namespace {

ExpressionMatrix unit_matrix(std::size_t size, const Algebra& algebra) {
  ExpressionMatrix unit(size, size, algebra.zero());
  for (std::size_t i = 0; i < size; ++i) unit(i, i) = algebra.number(1.0);
  return unit;
}

}  // namespace

Dynamics::Dynamics(const MechanicalSystem& system, const Algebra& algebra)
    : system_(system),
      algebra_(algebra),
      metric_(system.size(), system.size(), algebra.zero()),
      reaction_(system.constraints.size(), system.size(), algebra.zero()),
      acceleration_(reaction_),
      memory_(system.constraints.size(), system.memory.size(), algebra.zero()),
      raised_(system.size(), system.constraints.size(), algebra.zero()),
      inverse_(system.constraints.size(), system.constraints.size(), algebra.zero()) {
  set_constraints();
  set_free_motion();
}

Expressions Dynamics::at_order_one(const Expressions& of) const {
  const auto n = system_.size();
  return algebra_.pool().substituted(of, [&](int variable) {
    const auto column = static_cast<std::size_t>(std::max(variable - 1, 0));
    const bool is_memory = column >= 2 * n && column < system_.column_count();
    if (is_memory && system_.memory[column - 2 * n].order == 1.0)
      return algebra_.pool().variable(system_.v()[system_.memory[column - 2 * n].coordinate]);
    return algebra_.pool().variable(variable);
  });
}

// d/dt dL/dv_i = sum_j G_ij v_j' + sum_j (d^2 L/dv_i dq_j) v_j + d^2 L/dv_i dt.
void Dynamics::set_free_motion() {
  const auto velocity = algebra_.variables(system_.v());
  const auto momenta = algebra_.gradient(system_.lagrangian, system_.v());
  metric_ = algebra_.jacobian(momenta, system_.v());
  const auto mixed = algebra_.jacobian(momenta, system_.q());
  const auto transported =
      algebra_.sum(algebra_.product(mixed, velocity), algebra_.jacobian(momenta, {0}).entries);
  const auto slope = algebra_.gradient(system_.lagrangian, system_.q());
  forces_ = algebra_.sum(at_order_one(system_.forces), algebra_.difference(slope, transported));
  const auto directions = algebra_.transposed(reaction_);
  ExpressionMatrix right(system_.size(), directions.columns + 1, algebra_.zero());
  for (std::size_t i = 0; i < system_.size(); ++i) {
    right(i, 0) = forces_[i];
    for (std::size_t j = 0; j < directions.columns; ++j) right(i, j + 1) = directions(i, j);
  }
  const auto solved = algebra_.solve(metric_, right);
  for (std::size_t i = 0; i < system_.size(); ++i) {
    free_.push_back(solved(i, 0));
    for (std::size_t j = 0; j < directions.columns; ++j) raised_(i, j) = solved(i, j + 1);
  }
  if (has_constraints())
    inverse_ = algebra_.solve(algebra_.product(acceleration_, raised_), unit_matrix(value_.size(), algebra_));
}

void Dynamics::set_constraints() {
  const auto& f = system_.constraints;
  const auto velocity = algebra_.variables(system_.v());
  const auto by_velocity = algebra_.jacobian(f, system_.v());
  const auto by_memory = algebra_.jacobian(f, system_.w());
  reaction_.entries = at_order_one(by_velocity.entries);
  acceleration_ = reaction_;
  memory_.entries = at_order_one(by_memory.entries);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t k = 0; k < system_.memory.size(); ++k) {
      const auto& [coordinate, order] = system_.memory[k];
      if (order != 1.0) continue;
      acceleration_(i, coordinate) = algebra_.sum(acceleration_(i, coordinate), memory_(i, k));
      memory_(i, k) = algebra_.zero();
    }
  }
  value_ = at_order_one(f);
  convective_ = algebra_.sum(algebra_.product(algebra_.jacobian(value_, system_.q()), velocity),
                             algebra_.jacobian(value_, {0}).entries);
}

std::set<double> Dynamics::constraint_orders() const {
  std::set<double> orders;
  for (std::size_t i = 0; i < memory_.rows; ++i) {
    for (std::size_t k = 0; k < memory_.columns; ++k)
      if (!algebra_.is_zero(memory_(i, k))) orders.insert(system_.memory[k].order);
  }
  return orders;
}

std::optional<double> Dynamics::force_order_with_memory_rates() const {
  const auto orders = constraint_orders();
  if (orders.empty() || *orders.rbegin() > 1.0) return std::nullopt;
  const auto above = std::ranges::find_if(system_.memory, [](const auto& term) { return term.order > 1.0; });
  return above == system_.memory.end() ? std::nullopt : std::optional(above->order);
}

bool Dynamics::depends_on_motion(const Expressions& of) const {
  auto others = system_.v();
  const auto memory = system_.w();
  others.insert(others.end(), memory.begin(), memory.end());
  return std::ranges::any_of(of, [&](Expression e) {
    return std::ranges::any_of(others, [&](int variable) { return algebra_.pool().depends_on(e, variable); });
  });
}

Expressions Dynamics::multiplier(const Expressions& defect) const {
  return algebra_.negative(algebra_.product(inverse_, defect));
}

Expressions Dynamics::reaction(const Expressions& lambda) const { return algebra_.product(raised_, lambda); }

ExpressionMatrix Dynamics::compensation_matrix() const {
  ExpressionMatrix result = algebra_.product(raised_, inverse_);
  result.entries = algebra_.negative(result.entries);
  return result;
}

Expressions Dynamics::projected(const Expressions& x) const {
  return algebra_.sum(x, compensation(algebra_.product(acceleration_, x)));
}

Expressions Dynamics::free_defect() const {
  return algebra_.sum(algebra_.product(acceleration_, free_), convective_);
}

Expressions Dynamics::regular_multiplier() const { return multiplier(free_defect()); }

}  // namespace fde::bench::mechanics
