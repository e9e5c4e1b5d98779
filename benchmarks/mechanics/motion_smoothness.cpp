// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/motion_smoothness.hpp"

#include <algorithm>
#include <set>

#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/time_powers.hpp"

namespace fde::bench::mechanics {
namespace {

constexpr double last = 3.0;  // higher powers do not change the rate

// The powers of t with which a nonlinear motion starts, the same for all coordinates: all that may occur.
struct MotionExponents {
  std::vector<double> leaving{};    // of v - v(0)
  std::vector<double> velocity{};   // of v, with 0 if v(0) is not 0
  std::vector<double> free_part{};  // of P v, without 0
  std::set<double> singular{};      // 1 - order of the unbounded terms of v'
};

std::vector<double> shifted(std::vector<double> powers, double by) {
  for (double& power : powers) power += by;
  return powers;
}

std::vector<double> merged(std::vector<double> powers, const std::vector<double>& others) {
  powers.insert(powers.end(), others.begin(), others.end());
  return power_lattice(powers, {}, powers.empty() ? 0.0 : std::ranges::max(powers));
}

std::vector<double> with_zero(std::vector<double> powers) {
  powers.insert(powers.begin(), 0.0);
  return powers;
}

Expressions all_expressions(const MechanicalSystem& system) {
  Expressions all = system.forces;
  all.push_back(system.lagrangian);
  all.insert(all.end(), system.constraints.begin(), system.constraints.end());
  return all;
}

// The increments of powers: 1, and the orders of the rows of memory terms. Above order 1 the constraint
// determines b.v by a row of order alpha - 1.
std::vector<double> increments(const Dynamics& dynamics, const std::set<double>& of_time) {
  std::set<double> steps{1.0};
  steps.insert(of_time.begin(), of_time.end());
  const auto of_constraints = dynamics.constraint_orders();
  for (const auto& [coordinate, order] : dynamics.system().memory) {
    if (order < 1.0) steps.insert(1.0 - order);
    if (order > 1.0) steps.insert(of_constraints.contains(order) ? order - 1.0 : 2.0 - order);
  }
  return {steps.begin(), steps.end()};
}

// With a singular reaction v leaves v(0) like t^(1 - a), otherwise like t. A reaction of varying direction
// adds t^-a t^(1-b) to the rate of P v.
MotionExponents motion_exponents(const Dynamics& dynamics, const std::vector<double>& steps) {
  MotionExponents exponents;
  std::vector<double> first{1.0}, turning{1.0};
  for (const auto& [order, direction] : singular_directions(dynamics)) exponents.singular.insert(1.0 - order);
  for (const double a : exponents.singular) {
    first.push_back(a);
    for (const double b : exponents.singular) turning.push_back(a + b);
  }
  exponents.leaving = power_lattice(first, steps, last);
  const auto all = with_zero(exponents.leaving);
  exponents.velocity = dynamics.system().velocity.isZero(0.0) ? exponents.leaving : all;
  exponents.free_part = reaction_start(dynamics) == ReactionStart::singular_with_varying_direction
                            ? power_lattice(turning, steps, last)
                            : shifted(all, 1.0);
  return exponents;
}

// `above`: the order of the constraint if it is above 1, otherwise 0. In the multiplier form v has then the
// powers of its free part and of the part that the constraint determines.
std::vector<double> powers_of_row(const StateRow& row, const MotionExponents& exponents, bool has_multipliers,
                                  double above) {
  const auto regular = [&] {
    auto powers = exponents.leaving;
    std::erase_if(powers, [&](double p) {
      return std::ranges::any_of(exponents.singular, [&](double q) { return same_order(p, q); });
    });
    return powers;
  };
  switch (row.kind) {
    case RowKind::position:
      return shifted(exponents.velocity, 1.0);
    case RowKind::velocity:
      if (!has_multipliers) return exponents.leaving;
      return above == 0.0 ? exponents.free_part
                          : merged(exponents.free_part, shifted(exponents.leaving, above - 1.0));
    case RowKind::free_velocity:
      return exponents.free_part;
    case RowKind::constrained:
      return shifted(exponents.leaving, row.order - 1.0);
    case RowKind::rate:
      return shifted(regular(), -row.order);
    case RowKind::memory:
      if (row.order == above) return shifted(exponents.free_part, 1.0 - above);
      return row.order < 1.0 ? shifted(exponents.velocity, 1.0 - row.order)
                             : shifted(exponents.leaving, 1.0 - row.order);
    case RowKind::free_memory:
      return shifted(exponents.free_part, 1.0 - row.order);
    case RowKind::adjoint_memory:
    case RowKind::momentum:
    case RowKind::multiplier:
      break;
  }
  return {};
}

// The powers of a linear problem. Entries within rounding of 0 count as 0.
Smoothness linear_start(const Problem& problem, std::vector<PowerLoad> loads) {
  Vec constants(problem.size());
  problem.rhs(0.0, Vec::Zero(problem.size()), constants);
  loads.push_back({0.0, constants});
  Matrix matrix = std::get<DenseLinearPart>(problem.derivatives).matrix;
  for (auto column : matrix.colwise()) {
    const double rounding = 1e-14 * column.cwiseAbs().maxCoeff();
    column = (column.array().abs() < rounding).select(0.0, column).eval();
  }
  return linear_smoothness(problem.components, matrix, loads);
}

// All powers that may occur, from the orders of the rows.
Smoothness lattice_start(const std::vector<Component>& components, std::vector<double> steps) {
  for (const auto& component : components)
    if (!is_algebraic(component)) steps.push_back(component.order);
  Smoothness smoothness;
  for (const auto& component : components) {
    smoothness.powers.push_back(is_algebraic(component)
                                    ? std::vector<double>{}
                                    : power_lattice({component.order}, steps, component.order + 2.0));
  }
  return smoothness;
}

bool has_multipliers(const PosedEquations& equations) {
  return std::ranges::any_of(equations.components, is_algebraic);
}

// The rows of the multiplier form have the powers of the rows of a form without multipliers: v those of P v,
// and above order 1, where v is a component of the reaction's row, those of P v and chi.
Smoothness linear_start_with_multipliers(const Dynamics& dynamics, const PosedEquations& equations,
                                         double end) {
  const auto other = posed(
      dynamics, {dynamics.constraint_orders().empty() ? Formulation::acceleration : Formulation::integrated});
  if (!other.ill_posed_reason.empty()) return lattice_start(equations.components, {1.0});
  auto& pool = dynamics.algebra().pool();
  const auto known = linear_start(expression_problem(other.components, other.rhs, end, pool), other.loads);
  const auto powers_of = [&](RowKind kind, const StateRow& row) {
    for (std::size_t i = 0; i < other.rows.size(); ++i) {
      const auto& [found, coordinate, order] = other.rows[i];
      const bool same_memory = kind != RowKind::memory || order == row.order;
      if (found == kind && (coordinate == row.coordinate || kind == RowKind::constrained) && same_memory)
        return known.powers[i];
    }
    return std::vector<double>{};
  };
  Smoothness smoothness;
  for (const auto& row : equations.rows) {
    auto powers = powers_of(row.kind, row);
    if (row.kind == RowKind::velocity && powers.empty()) {
      powers = powers_of(RowKind::free_velocity, row);
      powers = merged(powers, powers_of(RowKind::constrained, row));
    }
    if (row.kind == RowKind::memory && powers.empty()) powers = powers_of(RowKind::free_memory, row);
    smoothness.powers.push_back(std::move(powers));
  }
  return smoothness;
}

Smoothness powers_at_start(const Dynamics& dynamics, const PosedEquations& equations,
                           const Problem& problem) {
  const auto& system = dynamics.system();
  const auto& pool = dynamics.algebra().pool();
  const auto all = all_expressions(system);
  const auto of_time = powers_of_time(pool, all, columns_at_start(system));
  if (!of_time) return {};
  const bool autonomous = std::ranges::none_of(all, [&](Expression e) { return pool.depends_on(e, 0); });
  if (is_linear(problem) && autonomous) {
    return has_multipliers(equations) ? linear_start_with_multipliers(dynamics, equations, problem.end)
                                      : linear_start(problem, equations.loads);
  }
  const auto steps = increments(dynamics, *of_time);
  if (dynamics.constraint_orders().empty()) return lattice_start(equations.components, steps);
  const auto exponents = motion_exponents(dynamics, steps);
  const double highest = *dynamics.constraint_orders().rbegin(), above = highest > 1.0 ? highest : 0.0;
  Smoothness smoothness;
  for (const auto& row : equations.rows)
    smoothness.powers.push_back(powers_of_row(row, exponents, has_multipliers(equations), above));
  return smoothness;
}

// Whether a right-hand side jumps where a function of t alone does: its sign or step, or a table of it. The
// sign of t itself jumps at 0 only.
bool jumps_in_time(Expression rhs, const ExpressionPool& pool) {
  return std::ranges::any_of(pool.arguments({rhs}, jumps), [&](Expression e) {
    return pool[e].operation != Operation::variable && pool.depends_on(e, 0) && !pool.depends_on_unknowns(e);
  });
}

}  // namespace

Smoothness motion_smoothness(const Dynamics& dynamics, const PosedEquations& equations,
                             const Problem& problem) {
  Smoothness smoothness = powers_at_start(dynamics, equations, problem);
  for (std::size_t i = 0; i < equations.rows.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (equations.rows[i].kind == RowKind::rate) smoothness.unmeasured.push_back(row);
    if (jumps_in_time(equations.rhs[i], dynamics.algebra().pool()))
      smoothness.breaking_points.push_back({row, 0.0});
  }
  return smoothness;
}

std::vector<double> powers_of_derivative(const std::vector<double>& powers, double order) {
  std::vector<double> lowered;
  for (const double power : powers)
    if (power > order && !same_order(power, order)) lowered.push_back(power - order);
  return lowered;
}

}  // namespace fde::bench::mechanics
