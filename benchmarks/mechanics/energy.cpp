// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_scene.hpp"

namespace fde::bench::mechanics {
namespace {

// v.dL/dv - L; for a metric without velocities 1/2 v'G v - L(v = 0), which does not cancel.
Expression energy(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  const auto velocity = algebra.variables(system.v());
  if (!dynamics.has_metric()) {
    const auto momenta = algebra.gradient(system.lagrangian, system.v());
    return algebra.difference(algebra.dot(momenta, velocity), system.lagrangian);
  }
  const auto first = system.v().front(), last = system.v().back();
  const auto at_rest = algebra.pool().substituted({system.lagrangian}, [&](int variable) {
    return variable < first || variable > last ? algebra.pool().variable(variable) : algebra.zero();
  });
  const auto square = algebra.dot(velocity, algebra.product(dynamics.metric(), velocity));
  return algebra.difference(algebra.product(algebra.number(0.5), square), at_rest[0]);
}

// v.(df/dv)^T lambda.
Expression reaction_power(const Dynamics& dynamics, const Expressions& lambda) {
  const auto& algebra = dynamics.algebra();
  return algebra.dot(
      algebra.product(dynamics.reaction_directions(), algebra.variables(dynamics.system().v())), lambda);
}

// The columns followed by values of the rates w', 0 for memory terms that are not given.
class ColumnsAndRates {
 public:
  ColumnsAndRates(const Dynamics& dynamics, std::vector<std::size_t> given)
      : columns_(static_cast<Eigen::Index>(dynamics.system().column_count())),
        size_(columns_ + std::ssize(dynamics.system().memory)),
        given_(std::move(given)) {}

  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] Vec joined(In columns, In rates) const {
    Vec all = Vec::Zero(size_);
    all.head(columns.size()) = columns;
    for (std::size_t i = 0; i < given_.size(); ++i)
      all[columns_ + static_cast<Eigen::Index>(given_[i])] = rates[static_cast<Eigen::Index>(i)];
    return all;
  }

 private:
  Eigen::Index columns_, size_;
  std::vector<std::size_t> given_;
};

// The memory terms, other than of order 1, that the constraints contain.
std::vector<std::size_t> differentiated_terms(const Dynamics& dynamics) {
  const auto& jacobian = dynamics.memory_jacobian();
  std::vector<std::size_t> terms;
  for (std::size_t k = 0; k < jacobian.columns; ++k) {
    bool occurs = false;
    for (std::size_t i = 0; i < jacobian.rows; ++i)
      occurs = occurs || !dynamics.algebra().is_zero(jacobian(i, k));
    if (occurs) terms.push_back(k);
  }
  return terms;
}

std::vector<Eigen::Index> columns_of(const std::vector<std::size_t>& terms, const MechanicalSystem& system) {
  std::vector<Eigen::Index> columns;
  for (const auto k : terms) columns.push_back(static_cast<Eigen::Index>(2 * system.size() + k));
  return columns;
}

Expressions column_of(const ExpressionMatrix& of, std::size_t k) {
  Expressions column;
  for (std::size_t i = 0; i < of.rows; ++i) column.push_back(of(i, k));
  return column;
}

Expressions memory_defect(const Dynamics& dynamics) {
  const auto& algebra = dynamics.algebra();
  return algebra.product(dynamics.memory_jacobian(), algebra.variables(dynamics.system().rates()));
}

std::vector<std::string> multiplier_names(std::size_t count) {
  if (count == 1) return {"lambda"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back("lambda" + std::to_string(i));
  return names;
}

std::optional<Vec> multiplier_at_start(const Dynamics& dynamics) {
  if (*dynamics.constraint_orders().rbegin() > 1.0) return initial_multiplier_above_one(dynamics);
  if (!singular_directions(dynamics).empty()) return std::nullopt;
  return initial_multiplier(dynamics);
}

}  // namespace

Outputs outputs_of(const PosedEquations& equations, const std::vector<std::string>& names,
                   const ExpressionPool& pool) {
  const Expressions shown(equations.columns.begin(),
                          equations.columns.begin() + static_cast<std::ptrdiff_t>(names.size()));
  std::vector<Eigen::Index> components;
  for (const auto e : shown)
    if (pool[e].operation == Operation::variable) components.push_back(pool[e].variable - 1);
  if (components.size() == shown.size()) return select_components(names, components);
  return {names, Program(pool, shown, std::ssize(equations.rows))};
}

Constraint constraint_of(const Dynamics& dynamics) {
  const auto& f = dynamics.constraint();
  const auto size = static_cast<Eigen::Index>(dynamics.system().shown_count());
  return {std::ssize(f), Program(dynamics.algebra().pool(), f, size)};
}

Energy energy_of(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  const auto& pool = algebra.pool();
  const auto size = static_cast<Eigen::Index>(system.shown_count());
  if (pool.depends_on(system.lagrangian, 0)) return {};
  Energy result;
  result.value = [program = Program(pool, {energy(dynamics)}, size)](In columns) {
    return program(0.0, columns);
  };
  const auto applied = algebra.dot(algebra.variables(system.v()), dynamics.at_order_one(system.forces));
  result.power =
      Program(pool, {algebra.sum(applied, reaction_power(dynamics, dynamics.regular_multiplier()))}, size);
  const auto terms = differentiated_terms(dynamics);
  if (terms.empty()) return result;
  result.differentiated_columns = columns_of(terms, system);
  Expressions shares;
  for (const auto k : terms)
    shares.push_back(reaction_power(dynamics, dynamics.multiplier(column_of(dynamics.memory_jacobian(), k))));
  result.rate_coefficients = Program(pool, shares, size);
  return result;
}

Reactions reactions_of(const Dynamics& dynamics, const std::vector<double>& start_exponents) {
  if (!dynamics.has_constraints()) return {};
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  const auto& pool = algebra.pool();
  const auto size = static_cast<Eigen::Index>(system.shown_count());
  Reactions reactions{.names = multiplier_names(system.constraints.size())};
  const auto velocity_factors =
      algebra.product(dynamics.reaction_directions(), algebra.variables(system.v()));
  reactions.power = [program = Program(pool, velocity_factors, size)](double t, In columns, In lambda) {
    Vec factors(lambda.size());
    program(t, columns, factors);
    return factors.dot(lambda);
  };
  const auto terms = differentiated_terms(dynamics);
  const ColumnsAndRates arguments(dynamics, terms);
  const auto lambda = dynamics.multiplier(algebra.sum(dynamics.free_defect(), memory_defect(dynamics)));
  reactions.multipliers = [arguments, program = Program(pool, lambda, arguments.size())](
                              double t, In columns, In rates, Out values) {
    program(t, arguments.joined(columns, rates), values);
  };
  if (terms.empty()) return reactions;
  reactions.differentiated_columns = columns_of(terms, system);
  reactions.start_exponents = start_exponents;
  reactions.initial_multipliers = multiplier_at_start(dynamics);
  return reactions;
}

}  // namespace fde::bench::mechanics
