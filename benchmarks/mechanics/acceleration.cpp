// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"

namespace fde::bench::mechanics {
namespace {

// The defect of df/dt + kappa f without reaction and without the part in w'.
Expressions damped_defect(const Dynamics& dynamics, double kappa) {
  const auto& algebra = dynamics.algebra();
  if (kappa == 0.0) return dynamics.free_defect();
  return algebra.sum(dynamics.free_defect(), algebra.product(algebra.number(kappa), dynamics.constraint()));
}

PosedEquations without_memory(const Dynamics& dynamics, double kappa) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  PosedEquations equations;
  const auto position = equations.add_rows(algebra.pool(), {RowKind::position}, 1.0, system.position);
  const auto velocity = equations.add_rows(algebra.pool(), {RowKind::velocity}, 1.0, system.velocity);
  const auto memory = add_memory_rows(equations, system);
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  const auto acceleration = in_state(
      equations,
      algebra.sum(dynamics.free_acceleration(), dynamics.compensation(damped_defect(dynamics, kappa))),
      algebra);
  equations.rhs = velocity;
  equations.append(acceleration);
  append_memory_rates(equations, memory, system, velocity, acceleration);
  return equations;
}

// t^power for power < 0, and 0 at t = 0. The sign is that of the time, which is 1 for t > 0.
Expression power_after_start(double power, const Algebra& algebra) {
  auto& pool = algebra.pool();
  const auto t = pool.variable(0), after = pool.make_expression(Operation::sign, t);
  const auto below = algebra.difference(algebra.number(1.0), after);
  const auto grown = pool.make_expression(Operation::power, t, algebra.number(-power));
  return algebra.quotient(after, algebra.sum(grown, below));
}

// The rows v, s_1, s_2, ... of one coordinate, and s_k as expressions of t and the state.
class RateChains {
 public:
  RateChains(const Dynamics& dynamics, PosedEquations& equations)
      : dynamics_(dynamics), singular_(singular_directions(dynamics)) {
    const auto& system = dynamics.system();
    const auto of_constraints = dynamics.constraint_orders();
    for (std::size_t i = 0; i < system.size(); ++i) {
      std::vector<double> orders;
      for (const auto& [coordinate, order] : system.memory)
        if (coordinate == i && of_constraints.contains(order)) orders.push_back(order);
      // Where v' is unbounded, v needs the rows from which its unbounded part is subtracted.
      const bool is_singular = std::ranges::any_of(
          singular_, [&](const auto& one) { return one.second[static_cast<Eigen::Index>(i)] != 0.0; });
      if (is_singular) orders.assign(of_constraints.begin(), of_constraints.end());
      std::ranges::sort(orders);
      orders_.push_back(orders);
    }
    const auto n = system.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double order = orders_[i].empty() ? 1.0 : orders_[i].front();
      const double start = system.velocity[static_cast<Eigen::Index>(i)];
      first_.push_back(equations.add_row({RowKind::velocity, i}, order, {start}));
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < orders_[i].size(); ++k) {
        const double next = k + 1 < orders_[i].size() ? orders_[i][k + 1] : 1.0;
        rows_.push_back(
            {i, k, equations.add_row({RowKind::rate, i, orders_[i][k]}, next - orders_[i][k], {0.0})});
      }
    }
  }

  [[nodiscard]] bool is_well_posed() const {
    double highest = 0.0;
    for (const auto& orders : orders_)
      if (!orders.empty()) highest = std::max(highest, orders.back());
    return std::ranges::all_of(singular_, [&](const auto& one) { return one.first + highest < 1.0; });
  }

  // The order of a memory term above 1 whose row D^(2 - order) w = v' has an unbounded right-hand side.
  [[nodiscard]] std::optional<double> unbounded_memory() const {
    for (const auto& [coordinate, order] : dynamics_.system().memory) {
      const auto is_unbounded = [&, i = static_cast<Eigen::Index>(coordinate)](const auto& one) {
        return one.second[i] != 0.0;
      };
      if (order > 1.0 && std::ranges::any_of(singular_, is_unbounded)) return order;
    }
    return std::nullopt;
  }

  [[nodiscard]] Expressions velocity() const {
    Expressions all;
    for (const int row : first_) all.push_back(dynamics_.algebra().pool().variable(row));
    return all;
  }

  // D^order v of a coordinate.
  [[nodiscard]] Expression rate(std::size_t coordinate, double order) const {
    const auto& algebra = dynamics_.algebra();
    for (const auto& [i, k, variable] : rows_) {
      if (i != coordinate || orders_[i][k] != order) continue;
      Expression value = algebra.pool().variable(variable);
      for (const auto& [a, direction] : singular_) {
        const double power = 1.0 - a - order;
        value = algebra.sum(value, singular_term(direction[static_cast<Eigen::Index>(i)], power));
      }
      return value;
    }
    return algebra.zero();
  }

  // The loads t^power that the rows of v contain.
  [[nodiscard]] std::vector<PowerLoad> loads(Eigen::Index size) const {
    std::vector<PowerLoad> all;
    for (const auto& [a, direction] : singular_) {
      for (std::size_t i = 0; i < orders_.size(); ++i) {
        if (orders_[i].empty() || direction[static_cast<Eigen::Index>(i)] == 0.0) continue;
        const double power = 1.0 - a - orders_[i].front();
        Vec coefficients = Vec::Zero(size);
        coefficients[first_[i] - 1] = direction[static_cast<Eigen::Index>(i)] / std::tgamma(1.0 + power);
        all.push_back({power, coefficients});
      }
    }
    return all;
  }

  // v' without its unbounded part: (compensation of (df/dw) v(0) - c) t^-a / Gamma(1 - a) is what remains of
  // it.
  [[nodiscard]] Expressions bounded_start(const PosedEquations& equations) const {
    const auto& algebra = dynamics_.algebra();
    const auto& system = dynamics_.system();
    Expressions total(system.size(), algebra.zero());
    for (const double order : all_orders()) {
      const auto& memory = dynamics_.memory_jacobian();
      Expressions defect(memory.rows, algebra.zero());
      for (std::size_t k = 0; k < system.memory.size(); ++k) {
        const auto& [coordinate, a] = system.memory[k];
        if (a != order) continue;
        const auto start = algebra.number(system.velocity[static_cast<Eigen::Index>(coordinate)]);
        for (std::size_t j = 0; j < memory.rows; ++j)
          defect[j] = algebra.sum(defect[j], algebra.product(memory(j, k), start));
      }
      auto rest = in_state(equations, dynamics_.compensation(defect), algebra);
      const auto singular = singular_.find(order);
      for (std::size_t i = 0; i < rest.size() && singular != singular_.end(); ++i)
        rest[i] = algebra.difference(rest[i], algebra.number(singular->second[static_cast<Eigen::Index>(i)]));
      if (is_constant(rest)) continue;  // then it is 0, as at the start
      const auto unbounded =
          algebra.product(algebra.number(1.0 / std::tgamma(1.0 - order)), power_after_start(-order, algebra));
      total = algebra.sum(total, algebra.product(unbounded, rest));
    }
    return total;
  }

  // The right-hand sides of the rows, with v' for the last one of each coordinate.
  void append_rates(PosedEquations& equations, const Expressions& acceleration) const {
    const auto& algebra = dynamics_.algebra();
    for (std::size_t i = 0; i < orders_.size(); ++i)
      equations.rhs.push_back(orders_[i].empty() ? acceleration[i] : rate(i, orders_[i].front()));
    for (const auto& [i, k, variable] : rows_) {
      const bool last = k + 1 == orders_[i].size();
      equations.rhs.push_back(last ? acceleration[i] : algebra.pool().variable(variable + 1));
    }
  }

 private:
  struct Row {
    std::size_t coordinate, place;  // the row of order orders_[coordinate][place]
    int variable;
  };

  [[nodiscard]] Expression singular_term(double coefficient, double power) const {
    const auto& algebra = dynamics_.algebra();
    if (coefficient == 0.0) return algebra.zero();
    const auto t = algebra.pool().variable(0);
    return algebra.product(algebra.number(coefficient / std::tgamma(1.0 + power)),
                           algebra.pool().make_expression(Operation::power, t, algebra.number(power)));
  }
  [[nodiscard]] bool is_constant(const Expressions& of) const {
    return std::ranges::all_of(of,
                               [&](Expression e) { return dynamics_.algebra().pool().value(e).has_value(); });
  }
  [[nodiscard]] std::vector<double> all_orders() const {
    std::vector<double> all;
    for (const auto& orders : orders_) all.insert(all.end(), orders.begin(), orders.end());
    return increasing(std::move(all));
  }

  const Dynamics& dynamics_;
  std::map<double, Vec> singular_;
  std::vector<std::vector<double>> orders_{};
  std::vector<int> first_{};
  std::vector<Row> rows_{};
};

PosedEquations with_memory(const Dynamics& dynamics, double kappa) {
  const auto& system = dynamics.system();
  const auto& algebra = dynamics.algebra();
  PosedEquations equations;
  const auto position = equations.add_rows(algebra.pool(), {RowKind::position}, 1.0, system.position);
  const RateChains chains(dynamics, equations);
  const auto formulation = kappa == 0.0 ? Formulation::acceleration : Formulation::stabilised;
  if (const auto order = chains.unbounded_memory()) {
    return {.ill_posed_reason = fmt::format("formulation = {}: must be multiplier: v' is unbounded at t = 0, "
                                            "and a force contains a derivative of "
                                            "order {}",
                                            name_of(formulation), *order)};
  }
  if (!chains.is_well_posed()) {
    return {.ill_posed_reason = fmt::format(
                "formulation = {}: must be neither acceleration nor stabilised for alpha = {}: "
                "v' starts like t^-alpha unless (df/dw) v(0) = 0, which they take for alpha < 1/2 only",
                name_of(formulation), *dynamics.constraint_orders().rbegin())};
  }
  const auto memory = add_memory_rows(equations, system);
  const auto velocity = chains.velocity();
  equations.columns = columns_from(position, velocity, memory, system, algebra);
  Expressions memory_rates;
  for (const auto& [coordinate, order] : system.memory)
    memory_rates.push_back(order < 1.0 ? chains.rate(coordinate, order) : algebra.zero());
  // w' is an expression of the state, the rest one of the columns.
  const auto remembered =
      algebra.product(in_state(equations, dynamics.memory_jacobian(), algebra), memory_rates);
  const auto defect = algebra.sum(in_state(equations, damped_defect(dynamics, kappa), algebra), remembered);
  const auto compensation =
      algebra.product(in_state(equations, dynamics.compensation_matrix(), algebra), defect);
  auto acceleration = algebra.sum(in_state(equations, dynamics.free_acceleration(), algebra), compensation);
  acceleration = algebra.sum(acceleration, chains.bounded_start(equations));
  equations.rhs = velocity;
  chains.append_rates(equations, acceleration);
  append_memory_rates(equations, memory, system, velocity, acceleration);
  equations.loads = chains.loads(std::ssize(equations.rows));
  return equations;
}

}  // namespace

PosedEquations acceleration_equations(const Dynamics& dynamics, double kappa) {
  return dynamics.constraint_orders().empty() ? without_memory(dynamics, kappa)
                                              : with_memory(dynamics, kappa);
}

}  // namespace fde::bench::mechanics
