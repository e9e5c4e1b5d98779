// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"

namespace fde::bench::mechanics {
namespace {

// The constraint a.v + b.w + sum_k b_k.w_k + c(t) = 0, w of order alpha above 1, with constants a, b, b_k.
class ConstantConstraint {
 public:
  explicit ConstantConstraint(const Dynamics& dynamics) : dynamics_(dynamics) {
    const auto& system = dynamics.system();
    const auto& algebra = dynamics.algebra();
    const auto n = static_cast<Eigen::Index>(system.size());
    auto constants = dynamics.reaction_directions().entries;
    for (const auto& entries : {dynamics.memory_jacobian().entries, dynamics.metric().entries})
      constants.insert(constants.end(), entries.begin(), entries.end());
    for (const auto e : constants)
      if (!algebra.pool().value(e)) refuse();
    const Expressions position_slopes = algebra.jacobian(dynamics.constraint(), system.q()).entries;
    for (const auto e : position_slopes)
      if (!algebra.is_zero(e)) refuse();
    const auto orders = dynamics.constraint_orders();
    alpha_ = *orders.rbegin();
    if (dynamics.constraint().size() != 1 || (orders.size() > 1 && *std::next(orders.rbegin()) > 1.0))
      refuse();
    direction_ = -at_start(dynamics, dynamics.compensation({algebra.number(1.0)}));
    by_velocity_ = at_start(dynamics, dynamics.acceleration_jacobian().entries);
    by_memory_ = Vec::Zero(n);
    const Vec memory = at_start(dynamics, dynamics.memory_jacobian().entries);
    for (std::size_t k = 0; k < system.memory.size(); ++k) {
      const auto& [coordinate, order] = system.memory[k];
      if (order == alpha_)
        by_memory_[static_cast<Eigen::Index>(coordinate)] += memory[static_cast<Eigen::Index>(k)];
      if (order > 1.0 && order != alpha_) refuse();
    }
    alignment_ = zero_if_rounding(by_memory_.dot(direction_), size_of(by_memory_, direction_));
  }

  [[nodiscard]] double order() const { return alpha_; }
  [[nodiscard]] const Vec& direction() const { return direction_; }  // a^#: a.a^# = 1
  [[nodiscard]] const Vec& by_memory() const { return by_memory_; }  // b
  [[nodiscard]] double alignment() const { return alignment_; }      // b.a^#
  [[nodiscard]] std::optional<std::size_t> memory_index(std::size_t coordinate) const {
    const auto& memory = dynamics_.system().memory;
    for (std::size_t k = 0; k < memory.size(); ++k)
      if (memory[k].coordinate == coordinate && memory[k].order == alpha_) return k;
    return std::nullopt;
  }

  // The w(0) along a^# with f = 0; 0 if b.a^# = 0.
  [[nodiscard]] Vec initial_memory() const {
    const auto& system = dynamics_.system();
    if (alignment_ == 0.0) return Vec::Zero(direction_.size());
    const double rest = at_start(dynamics_, remaining_constraint())[0];
    const double size = size_of(by_velocity_, system.velocity) + std::abs(rest);
    return direction_ * (-zero_if_rounding(by_velocity_.dot(system.velocity) + rest, size) / alignment_);
  }

  // The same without rounding. Precondition: the pool has fractions.
  [[nodiscard]] Expressions exact_initial_memory() const {
    const auto& algebra = dynamics_.algebra();
    const auto direction = algebra.negative(dynamics_.compensation({algebra.number(1.0)}));
    const auto velocity = algebra.numbers(dynamics_.system().velocity);
    Expression defect = algebra.sum(algebra.dot(dynamics_.acceleration_jacobian().entries, velocity),
                                    remaining_constraint()[0]);
    Expression alignment = algebra.zero();
    for (std::size_t k = 0; k < dynamics_.system().memory.size(); ++k) {
      const auto& [coordinate, order] = dynamics_.system().memory[k];
      if (order != alpha_) continue;
      const auto along = algebra.product(dynamics_.memory_jacobian()(0, k), direction[coordinate]);
      alignment = algebra.sum(alignment, along);
    }
    const auto start = columns_at_start(dynamics_.system());
    const auto all = algebra.product(algebra.negative(algebra.quotient(defect, alignment)), direction);
    return algebra.pool().substituted(all, [&](int variable) {
      return variable == 0 ? algebra.zero() : algebra.number(start[variable - 1]);
    });
  }

  // c(t) + sum_k b_k.w_k as an expression of t and the columns.
  [[nodiscard]] Expressions remaining_constraint() const {
    const auto& system = dynamics_.system();
    const auto& algebra = dynamics_.algebra();
    const auto n = system.size();
    return algebra.pool().substituted(dynamics_.constraint(), [&](int variable) {
      const auto column = static_cast<std::size_t>(variable) - 1;
      const bool removed =
          variable != 0 && column >= n && (column < 2 * n || system.memory[column - 2 * n].order == alpha_);
      return removed ? algebra.zero() : algebra.pool().variable(variable);
    });
  }

 private:
  [[noreturn]] static void refuse() {
    throw ConstraintError(
        0,
        "contains an order above 1: must then be the only constraint, with one such order and constant "
        "coefficients, in a metric with constant entries");
  }
  static double size_of(const Vec& x, const Vec& y) { return x.cwiseAbs().dot(y.cwiseAbs()); }

  const Dynamics& dynamics_;
  Vec direction_, by_velocity_, by_memory_;
  double alpha_ = 0.0, alignment_ = 0.0;
};

}  // namespace

std::optional<Vec> initial_multiplier_above_one(const Dynamics& dynamics) {
  const ConstantConstraint constraint(dynamics);
  if (constraint.alignment() == 0.0 || !constraint.initial_memory().isZero(0.0)) return std::nullopt;
  // b.v'(0) = 0: otherwise b.w, and with it a.v, starts like t^(2-alpha)
  const auto& algebra = dynamics.algebra();
  const auto& b = constraint.by_memory();
  const auto defect = algebra.dot(algebra.numbers(b), dynamics.free_acceleration());
  const auto stiffness =
      algebra.product(dynamics.acceleration_jacobian(), dynamics.reaction_matrix());  // a G^-1 a^T
  return Vec::Constant(1, -at_start(dynamics, {defect})[0] /
                              (constraint.alignment() * at_start(dynamics, stiffness.entries)[0]));
}

PosedEquations integrated_above_one(const Dynamics& dynamics) {
  const ConstantConstraint constraint(dynamics);
  if (constraint.alignment() == 0.0) {
    return {.ill_posed_reason =
                fmt::format("formulation = integrated: must be multiplier for alpha = {} and a.b = 0: above "
                            "1 the constraint then fixes no derivative of order alpha",
                            constraint.order())};
  }
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  const auto n = system.size();
  const double order = constraint.order();
  const Vec free_part = at_start(dynamics, dynamics.projected(algebra.numbers(system.velocity)));
  PosedEquations equations;
  const auto position = equations.add_rows(pool, {RowKind::position}, 1.0, system.position);
  const auto z = equations.add_rows(pool, {RowKind::free_velocity}, 1.0, free_part);
  const auto chi = pool.variable(equations.add_row({RowKind::constrained, 0, order}, order - 1.0,
                                                   {constraint.by_memory().dot(system.velocity)}));
  const auto free_memory = equations.add_rows(pool, {RowKind::free_memory, 0, order}, 2.0 - order,
                                              Vec::Zero(static_cast<Eigen::Index>(n)));
  const auto memory = add_memory_rows(equations, system, 1.0);
  const auto b = algebra.numbers(constraint.by_memory()), direction = algebra.numbers(constraint.direction());
  const auto alignment = algebra.number(constraint.alignment());
  const auto fixed = algebra.quotient(algebra.difference(chi, algebra.dot(b, z)), alignment);
  const auto velocity = algebra.sum(z, algebra.product(fixed, direction));
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  const auto rest = in_state(equations, constraint.remaining_constraint(), algebra)[0];
  const auto remembered = algebra.negative(algebra.sum(rest, fixed));  // b.w
  const auto along = algebra.quotient(algebra.difference(remembered, algebra.dot(b, free_memory)), alignment);
  for (std::size_t i = 0; i < n; ++i) {
    if (const auto k = constraint.memory_index(i))
      equations.columns[2 * n + *k] = algebra.sum(free_memory[i], algebra.product(along, direction[i]));
  }
  const auto free = in_state(equations, dynamics.projected(dynamics.free_acceleration()), algebra);
  equations.rhs = velocity;
  equations.append(free);
  equations.append({remembered});
  equations.append(free);
  append_memory_rates(equations, memory, system, velocity, {});
  return equations;
}

PosedEquations multiplier_above_one(const Dynamics& dynamics) {
  const ConstantConstraint constraint(dynamics);
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  const auto n = system.size();
  const double order = constraint.order();
  const Vec initial = constraint.initial_memory();
  const auto guess = initial_multiplier_above_one(dynamics);
  PosedEquations equations;
  const auto position = equations.add_rows(pool, {RowKind::position}, 1.0, system.position);
  const auto velocity = equations.add_rows(pool, {RowKind::velocity, 0, order}, order - 1.0, system.velocity);
  const bool has_exact = pool.has_fractions() && !initial.isZero(0.0);
  const Expressions exact = has_exact ? constraint.exact_initial_memory() : Expressions{};
  for (std::size_t i = 0; i < exact.size(); ++i)
    equations.exact_initial[equations.rows.size() + i] = exact[i];
  const auto remembered = equations.add_rows(pool, {RowKind::memory, 0, order}, 2.0 - order, initial);
  const auto memory = add_memory_rows(equations, system, 1.0);
  const auto lambda =
      pool.variable(equations.add_row({RowKind::multiplier}, 0.0, {guess ? (*guess)[0] : 0.0}));
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  for (std::size_t k = 0; k < memory.size(); ++k)
    if (memory[k] == 0) equations.columns[2 * n + k] = remembered[system.memory[k].coordinate];
  const auto acceleration =
      algebra.sum(in_state(equations, dynamics.free_acceleration(), algebra),
                  algebra.product(in_state(equations, dynamics.reaction_matrix(), algebra), {lambda}));
  equations.rhs = velocity;
  equations.append(remembered);
  equations.append(acceleration);
  append_memory_rates(equations, memory, system, velocity, {});
  equations.append(in_state(equations, dynamics.constraint(), algebra));
  return equations;
}

}  // namespace fde::bench::mechanics
