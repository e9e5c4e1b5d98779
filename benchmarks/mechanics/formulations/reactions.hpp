// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/formulations/setting.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

// The reactions of the constraints as functions of the columns, the same for every formulation: lambda by
// Tarasov & Zaslavsky (36), with w' as the rate of the columns w.
namespace fde::bench::mechanics {

// The positions of q, v and, with memory, w = D^order q among the columns of a scene; without memory w is v.
template <class System>
constexpr Layout column_layout() {
  constexpr int n = System::coordinates;
  return {.q = {0, n}, .v = {n, n}, .w = {HasMemory<System> ? 2 * n : n, n}};
}

// Whether w is a column of its own: only with memory and an order other than 1.
template <class System>
bool has_memory_column([[maybe_unused]] const System& system) {
  if constexpr (HasMemory<System>) {
    return system.order != 1.0;
  } else {
    return false;
  }
}

// The constraints and their reaction at one time, from the columns.
template <class System>
struct ReactionAt {
  static constexpr int n = System::coordinates, r = System::constraints;
  static constexpr Layout at = column_layout<System>();
  using Point = Vector<double, n>;
  Point q, v;
  ConstraintLinearization<double, System> rates;
  Reaction<double, System> reaction;

  ReactionAt(const System& system, double t, In columns)
      : q(part<at.q>(columns)),
        v(part<at.v>(columns)),
        rates(linearize_constraints<double>(system, t, q, v, Point(part<at.w>(columns)))),
        reaction(system, q, rates) {}

  // lambda without the contribution of w', and that contribution.
  [[nodiscard]] Vector<double, r> regular_part(const System& system, double t) const {
    return reaction.multiplier(rates.acceleration_jacobian * free_acceleration<double>(system, t, q, v) +
                               rates.convective_rate);
  }
  [[nodiscard]] Vector<double, r> memory_part(const Point& memory_rate) const {
    return reaction.multiplier(rates.memory_jacobian * memory_rate);
  }
  [[nodiscard]] double power(const Vector<double, r>& lambda) const {
    return v.dot(rates.velocity_jacobian.transpose() * lambda);
  }
};

// lambda(0), or nullopt if it is unbounded.
template <class System>
std::optional<Vec> multiplier_at_start(const System& system, const InitialState<System::coordinates>& start) {
  if constexpr (ConstantCoefficients<System>) {
    if (system.order > 1.0) {
      const ConstantConstraint<System> constraint(system, start.q);
      if (constraint.alignment() == 0.0 || !constraint.initial_memory(start.v).isZero(0.0))
        return std::nullopt;
      return Vec(initial_multiplier<MemoryRows::above_one>(system, start));
    }
  }
  if (!singular_direction(system, start).isZero(0.0)) return std::nullopt;
  return Vec(initial_multiplier<MemoryRows::below_one>(system, start));
}

inline std::vector<std::string> multiplier_names(int count) {
  if (count == 1) return {"lambda"};
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) names.push_back("lambda" + std::to_string(i));
  return names;
}

// The reactions of the constraints. `powers`: the exponents with which the columns w start; used if
// has_memory_column(system).
template <class System>
Reactions reactions_of(const System& system, const InitialState<System::coordinates>& start,
                       std::vector<double> powers) {
  using At = ReactionAt<System>;
  Reactions reactions{.names = multiplier_names(System::constraints)};
  reactions.power = [system](double t, In columns, In lambda) {
    return At(system, t, columns).power(Vector<double, At::r>(lambda));
  };
  if (!has_memory_column(system)) {
    reactions.multipliers = [system](double t, In columns, In /*rates*/, Out lambda) {
      lambda = At(system, t, columns).regular_part(system, t);
    };
    return reactions;
  }
  for (int i = 0; i < At::n; ++i) reactions.differentiated_columns.push_back(At::at.w.first + i);
  reactions.start_exponents = std::move(powers);
  reactions.multipliers = [system](double t, In columns, In rates, Out lambda) {
    const At here(system, t, columns);
    lambda = here.regular_part(system, t) + here.memory_part(typename At::Point(rates));
  };
  if constexpr (HasMemory<System>) reactions.initial_multipliers = multiplier_at_start(system, start);
  return reactions;
}

// 1/2 v'G v + u.
template <class System>
double energy_at([[maybe_unused]] const System& system, const Vector<double, System::coordinates>& q,
                 const Vector<double, System::coordinates>& v) {
  double value = 0.0;
  if constexpr (HasMetric<System>) {
    value = 0.5 * v.dot(system.template metric<double>(q) * v);
  } else {
    value = 0.5 * v.squaredNorm();
  }
  if constexpr (HasPotential<System>) value += system.template potential<double>(q);
  return value;
}

// E = 1/2 v'G v + u. Its rate is the power of forces and reactions; with memory the reaction has a term in
// w'.
template <class System>
Energy energy_of(const System& system) {
  using At = ReactionAt<System>;
  Energy energy;
  energy.value = [system](In columns) {
    using Point = typename At::Point;
    return energy_at(system, Point(part<At::at.q>(columns)), Point(part<At::at.v>(columns)));
  };
  energy.power = [system](double t, In columns) {
    const At here(system, t, columns);
    double power = here.power(here.regular_part(system, t));
    if constexpr (HasForce<System>) power += here.v.dot(system.template force<double>(t, here.q, here.v));
    return power;
  };
  if (!has_memory_column(system)) return energy;
  for (int i = 0; i < At::n; ++i) energy.differentiated_columns.push_back(At::at.w.first + i);
  energy.rate_coefficients = [system](double t, In columns, Out shares) {
    const At here(system, t, columns);
    for (int i = 0; i < At::n; ++i) shares[i] = here.power(here.memory_part(At::Point::Unit(i)));
  };
  return energy;
}

}  // namespace fde::bench::mechanics
