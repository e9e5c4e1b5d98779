// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/extremum_scene.hpp"

#include <algorithm>

#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/time_powers.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_scene.hpp"
#include "fdebench/benchmarks/mechanics/memory_extremum.hpp"

namespace fde::bench::mechanics {
namespace {

bool is_two_sided(const MechanicalSystem& system, const ExtremumEnds& ends) {
  return !system.memory.empty() ||
         std::ranges::any_of(ends.final, [](const auto& last) { return last.has_value(); });
}

// The expressions of the extremum in t, q, w and the momenta p, which have the variables of the velocities.
class Momenta {
 public:
  explicit Momenta(const Dynamics& dynamics) : dynamics_(dynamics) {
    const auto& system = dynamics.system();
    const auto& algebra = dynamics.algebra();
    const auto momenta = algebra.variables(system.v());
    const auto at_rest = algebra.gradient(system.lagrangian, system.v());
    const auto free =
        algebra.solve(dynamics.metric(), algebra.difference(momenta, without_velocities(at_rest)));
    const auto reactions = algebra.product(dynamics.reaction_directions(), dynamics.reaction_matrix());
    const auto defect = algebra.sum(algebra.product(dynamics.reaction_directions(), free),
                                    without_velocities(dynamics.constraint()));
    multipliers_ = defect.empty() ? Expressions{} : algebra.solve(reactions, defect);
    velocity_ = algebra.difference(free, dynamics.reaction(multipliers_));
  }

  [[nodiscard]] const Expressions& multipliers() const { return multipliers_; }
  [[nodiscard]] const Expressions& velocity() const { return velocity_; }

  // Whether f = 0 at v = 0.
  [[nodiscard]] bool has_linear_constraints() const {
    return std::ranges::all_of(without_velocities(dynamics_.constraint()),
                               [&](Expression e) { return dynamics_.algebra().is_zero(e); });
  }

  // d(L + mu f) / d variables, with v and mu as functions of p.
  [[nodiscard]] Expressions slopes(const std::vector<int>& variables) const {
    const auto& algebra = dynamics_.algebra();
    const auto& system = dynamics_.system();
    auto slope = at_momenta(algebra.gradient(system.lagrangian, variables));
    const auto by_constraint = algebra.jacobian(dynamics_.constraint(), variables);
    for (std::size_t j = 0; j < by_constraint.rows; ++j) {
      Expressions row;
      for (std::size_t i = 0; i < variables.size(); ++i) row.push_back(by_constraint(j, i));
      slope = algebra.sum(slope, algebra.product(multipliers_[j], at_momenta(row)));
    }
    return slope;
  }

  // Expressions of t and the columns with v as a function of p.
  [[nodiscard]] Expressions at_momenta(const Expressions& of) const { return with_velocity(of, velocity_); }

 private:
  [[nodiscard]] Expression pool_variable(int i) const { return dynamics_.algebra().pool().variable(i); }
  [[nodiscard]] Expressions with_velocity(const Expressions& of, const Expressions& velocity) const {
    const auto first = dynamics_.system().v().front();
    return dynamics_.algebra().pool().substituted(of, [&](int variable) {
      const auto i = static_cast<std::size_t>(variable - first);
      return variable >= first && i < velocity.size() ? velocity[i] : pool_variable(variable);
    });
  }
  [[nodiscard]] Expressions without_velocities(const Expressions& of) const {
    return with_velocity(of, Expressions(dynamics_.system().size(), dynamics_.algebra().zero()));
  }

  const Dynamics& dynamics_;
  Expressions multipliers_{}, velocity_{};
};

double value(const Vec& of, std::size_t i) { return of[static_cast<Eigen::Index>(i)]; }

// p(0) = dL/dv + (df/dv)^T mu(0).
Vec initial_momenta(const Dynamics& dynamics, const Vec& multipliers) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto momenta = algebra.gradient(system.lagrangian, system.v());
  for (std::size_t j = 0; j < dynamics.constraint().size(); ++j) {
    for (std::size_t i = 0; i < system.size(); ++i) {
      momenta[i] = algebra.sum(momenta[i], algebra.product(algebra.number(value(multipliers, j)),
                                                           dynamics.reaction_directions()(j, i)));
    }
  }
  return at_start(dynamics, momenta);
}

struct ExtremumRows {
  PosedEquations equations{};
  std::vector<Eigen::Index> given_ends{};  // the positions with a value at the end
};

// Rows q, w and, on the right side, r and P; with initial values P is a left row.
ExtremumRows extremum_rows(const Dynamics& dynamics, const ExtremumEnds& ends) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  auto& pool = algebra.pool();
  const bool two_sided = is_two_sided(system, ends);
  ExtremumRows result;
  auto& equations = result.equations;
  Expressions momenta;
  const auto position = equations.add_rows(pool, {RowKind::position}, 1.0, system.position);
  const auto memory = add_memory_rows(equations, system);
  std::vector<int> adjoint;
  for (const auto& [coordinate, order] : system.memory) {
    adjoint.push_back(equations.add_row({RowKind::adjoint_memory, coordinate, order}, 1.0 - order, {0.0}));
    equations.components.back().side = Side::right;
  }
  const Vec initial = two_sided ? Vec() : initial_momenta(dynamics, ends.multipliers);
  for (std::size_t i = 0; i < system.size(); ++i) {
    std::vector<double> known;
    if (!two_sided) known = {value(initial, i)};
    if (two_sided && !ends.final[i]) known = {0.0};
    if (two_sided && ends.final[i]) result.given_ends.push_back(static_cast<Eigen::Index>(i));
    momenta.push_back(pool.variable(equations.add_row({RowKind::momentum, i}, 1.0, known)));
    if (two_sided) equations.components.back().side = Side::right;
  }
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    auto& p = momenta[system.memory[k].coordinate];
    p = algebra.difference(p, pool.variable(adjoint[k]));
  }
  equations.columns = columns_from(position, momenta, memory, system, algebra);
  const Momenta extremum(dynamics);
  const auto velocity = in_state(equations, extremum.velocity(), algebra);
  auto rates = algebra.sum(extremum.slopes(system.q()), extremum.at_momenta(system.forces));
  if (two_sided) rates = algebra.negative(rates);
  equations.rhs = velocity;
  append_memory_rates(equations, memory, system, velocity, {});
  for (const auto& more : {extremum.slopes(system.w()), rates}) {
    equations.append(in_state(equations, more, algebra));
  }
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  return result;
}

// All powers that may occur: steps of 1 and of the orders of memory rows.
Smoothness extremum_smoothness(const Dynamics& dynamics, const PosedEquations& equations) {
  const auto& system = dynamics.system();
  auto all = system.constraints;
  all.push_back(system.lagrangian);
  const auto of_time = powers_of_time(dynamics.algebra().pool(), all, columns_at_start(system));
  if (!of_time) return {};
  std::vector<double> steps(of_time->begin(), of_time->end());
  steps.push_back(1.0);
  for (const auto& [coordinate, order] : system.memory) steps.push_back(1.0 - order);
  Smoothness smoothness;
  for (const auto& component : equations.components)
    smoothness.powers.push_back(power_lattice({component.order}, steps, component.order + 2.0));
  return smoothness;
}

void require_affine(const Dynamics& dynamics) {
  if (!dynamics.has_metric()) {
    throw std::invalid_argument(
        "its second derivatives with respect to velocities depend on them: must not, here");
  }
  const auto& entries = dynamics.reaction_directions();
  for (std::size_t j = 0; j < entries.rows; ++j) {
    for (std::size_t i = 0; i < entries.columns; ++i) {
      for (const int v : dynamics.system().v()) {
        if (dynamics.algebra().pool().depends_on(entries(j, i), v))
          throw ConstraintError(j, "is not affine in the velocity: must be so where principle = vakonomic");
      }
    }
  }
}

}  // namespace

Scene extremum_scene(const MechanicalSystem& system, const ExtremumEnds& ends,
                     const std::vector<std::string>& names, double end, ExpressionPool& pool) {
  if (is_memory_lagrangian(system, pool)) return memory_extremum_scene(system, ends, names, end, pool);
  const Algebra algebra(pool);
  const Dynamics dynamics(system, algebra);
  require_regular_start(dynamics);
  require_affine(dynamics);
  const bool two_sided = is_two_sided(system, ends);
  if (!two_sided) require_start_on_constraints(dynamics);
  const auto [equations, given] = extremum_rows(dynamics, ends);
  Scene scene;
  scene.problem = expression_problem(equations.components, equations.rhs, end, pool);
  scene.smoothness = extremum_smoothness(dynamics, equations);
  scene.outputs = outputs_of(equations, names, pool);
  if (!given.empty()) {
    Vec last(std::ssize(given));
    for (std::size_t i = 0; i < given.size(); ++i)
      last[static_cast<Eigen::Index>(i)] = *ends.final[static_cast<std::size_t>(given[i])];
    scene.problem.conditions = [rows = given, last](In, In at_end, Out residual) {
      residual = at_end(rows) - last;
    };
  }
  if (system.memory.empty()) scene.energy = energy_of(dynamics);
  // The energy changes by the work of the multipliers, which are not functions of the columns, unless f is
  // linear in v.
  scene.energy.power = {};
  const Momenta momenta(dynamics);
  const auto is_zero = [&](Expression e) { return algebra.is_zero(e); };
  if (scene.energy && std::ranges::all_of(system.forces, is_zero) && momenta.has_linear_constraints())
    scene.energy.power = [](double, In) { return 0.0; };
  if (dynamics.has_constraints()) scene.constraint = constraint_of(dynamics);
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    const auto n = static_cast<Eigen::Index>(system.size());
    const auto& [coordinate, order] = system.memory[k];
    scene.memory_columns.push_back(
        {2 * n + static_cast<Eigen::Index>(k), n + static_cast<Eigen::Index>(coordinate), order});
  }
  return scene;
}

}  // namespace fde::bench::mechanics
