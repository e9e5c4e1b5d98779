// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/mechanical_scene.hpp"

#include <algorithm>
#include <utility>

#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/mechanics/motion_smoothness.hpp"

namespace fde::bench::mechanics {
namespace {

// A problem with its columns and its smoothness; empty if it is not well posed.
struct PosedMotion {
  PosedProblem posed{};
  Smoothness smoothness{};
};

// Where the constraints keep their rank; everywhere if their matrices are constant.
Domain regular_domain(const Dynamics& dynamics, const PosedEquations& equations) {
  const auto& algebra = dynamics.algebra();
  const auto& pool = algebra.pool();
  const auto r = static_cast<Eigen::Index>(dynamics.constraint().size());
  const auto n = static_cast<Eigen::Index>(dynamics.system().size());
  const auto& gradients = dynamics.acceleration_jacobian();
  // Where A = R the metric, which is positive, does not matter.
  const bool is_symmetric = gradients.entries == dynamics.reaction_directions().entries;
  const auto reactions = is_symmetric ? algebra.transposed(gradients) : dynamics.reaction_matrix();
  Expressions entries = in_state(equations, gradients, algebra).entries;
  for (const auto e : in_state(equations, reactions, algebra).entries) entries.push_back(e);
  if (std::ranges::all_of(entries, [&](Expression e) { return pool.value(e).has_value(); })) return {};
  return {
      .edge = "where the constraints lose their rank",
      .constraints = [r, n, program = Program(pool, entries, std::ssize(equations.rows))](double t, In y) {
        using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Vec values(2 * r * n);
        program(t, y, values);
        return ConstraintMatrices{Eigen::Map<const ByRows>(values.data(), r, n),
                                  Eigen::Map<const ByRows>(values.data() + r * n, n, r)};
      }};
}

PosedMotion motion_of(const Dynamics& dynamics, const PosedEquations& equations,
                      const std::vector<std::string>& names, double end) {
  auto& pool = dynamics.algebra().pool();
  PosedMotion motion;
  motion.posed.problem = expression_problem(equations.components, equations.rhs, end, pool);
  motion.posed.problem.domain = regular_domain(dynamics, equations);
  motion.posed.outputs = outputs_of(equations, names, pool);
  // Above order 1 the velocities and their memory follow from the state through 1 / (b.a^#).
  if (std::ranges::find(equations.rows, RowKind::constrained, &StateRow::kind) != equations.rows.end()) {
    motion.posed.problem.outputs = [outputs = motion.posed.outputs](double t, In y) {
      return columns_at(outputs, t, y);
    };
  }
  motion.smoothness = motion_smoothness(dynamics, equations, motion.posed.problem);
  return motion;
}

// The powers of the rows q, one list a coordinate.
std::vector<std::vector<double>> position_powers(const PosedEquations& equations,
                                                 const Smoothness& smoothness) {
  std::vector<std::vector<double>> powers;
  for (std::size_t i = 0; i < smoothness.powers.size(); ++i)
    if (equations.rows[i].kind == RowKind::position) powers.push_back(smoothness.powers[i]);
  return powers;
}

void add_memory_columns(Scene& scene, const MechanicalSystem& system,
                        const std::vector<std::vector<double>>& powers) {
  const auto n = static_cast<Eigen::Index>(system.size());
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    const auto& [coordinate, order] = system.memory[k];
    if (order == 1.0) continue;
    scene.memory_columns.push_back(
        {2 * n + static_cast<Eigen::Index>(k), n + static_cast<Eigen::Index>(coordinate), order,
         powers.empty() ? std::vector<double>{} : powers_of_derivative(powers[coordinate], 1.0)});
  }
}

std::vector<double> memory_powers(const Dynamics& dynamics, const std::vector<std::vector<double>>& powers) {
  std::vector<double> all;
  for (const double order : dynamics.constraint_orders()) {
    for (const auto& of_position : powers) {
      const auto lowered = powers_of_derivative(of_position, order);
      all.insert(all.end(), lowered.begin(), lowered.end());
    }
  }
  return all;
}

bool has_free_start(const Dynamics& dynamics) {
  const auto orders = dynamics.constraint_orders();
  return !orders.empty() && *orders.rbegin() > 1.0 && integrated_above_one(dynamics).ill_posed_reason.empty();
}

}  // namespace

Scene mechanical_scene(const MechanicalSystem& system, const FormulationChoice& choice,
                       const std::vector<std::string>& names, double end, ExpressionPool& pool) {
  const Algebra algebra(pool);
  MechanicalSystem moving = system;
  const Dynamics dynamics(moving, algebra);
  require_regular_start(dynamics);
  if (!has_free_start(dynamics)) require_start_on_constraints(dynamics);
  moving.velocity = consistent_velocity(dynamics);
  Scene scene;
  const auto equations = posed(dynamics, choice);
  scene.ill_posed_reason = equations.ill_posed_reason;
  std::vector<std::vector<double>> powers;
  if (scene.ill_posed_reason.empty()) {
    auto motion = motion_of(dynamics, equations, names, end);
    scene.problem = std::move(motion.posed.problem);
    scene.outputs = std::move(motion.posed.outputs);
    scene.smoothness = std::move(motion.smoothness);
    powers = position_powers(equations, scene.smoothness);
  } else {
    scene.outputs.names = names;
    scene.problem.end = end;
  }
  const auto best = dynamics.has_constraints() ? reference_formulation(dynamics) : choice.formulation;
  if (best != choice.formulation) {
    const auto reference = posed(dynamics, {best});
    auto motion = motion_of(dynamics, reference, names, end);
    powers = position_powers(reference, motion.smoothness);  // the solution is the same
    scene.reference_problem = std::move(motion.posed);
  }
  scene.energy = energy_of(dynamics);
  if (dynamics.has_constraints()) scene.constraint = constraint_of(dynamics);
  if (dynamics.has_metric())
    scene.geometry = geometry_of(dynamics, {names.begin(), names.begin() + std::ssize(system.coordinates)});
  add_memory_columns(scene, moving, powers);
  scene.reactions = reactions_of(dynamics, memory_powers(dynamics, powers));
  return scene;
}

std::vector<Formulation> formulations_of(const MechanicalSystem& system, ExpressionPool& pool) {
  if (system.constraints.empty()) return {};
  const Algebra algebra(pool);
  return Dynamics(system, algebra).is_affine() ? all_formulations() : unprojected_formulations();
}

}  // namespace fde::bench::mechanics
