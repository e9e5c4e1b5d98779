// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/formulations/acceleration.hpp"
#include "fdebench/benchmarks/mechanics/formulations/integrated_above_one.hpp"
#include "fdebench/benchmarks/mechanics/memory_rows.hpp"
#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/mechanics/reaction.hpp"

namespace fde::bench::mechanics {

// A guess of lambda(0). If lambda is unbounded at 0, the guess is 0; only the value of lambda at t = 0 is
// wrong then, because the constraint determines the effect of lambda on v.
template <MemoryRows memory, class System>
Vector<double, System::constraints> initial_multiplier(const System& system,
                                                       const InitialState<System::coordinates>& start) {
  constexpr int n = System::coordinates, r = System::constraints;
  const Vector<double, n> w = memory == MemoryRows::none ? start.v : zeros<double, n>();
  auto rates = linearize_constraints<double>(system, 0.0, start.q, start.v, w);
  if constexpr (memory == MemoryRows::below_one) {
    if (!singular_direction(system, start).isZero(0.0)) return zeros<double, r>();
  }
  if constexpr (memory == MemoryRows::above_one) {
    const ConstantConstraint<System> constraint(system, start.q);
    if (constraint.alignment() == 0.0) return zeros<double, r>();
    if (!constraint.initial_memory(start.v).isZero(0.0)) return zeros<double, r>();
    rates.acceleration_jacobian =
        rates.memory_jacobian;  // b.v'(0) = 0: otherwise b.w, and with it a.v, starts like t^(2-alpha)
  }
  return enforcing_multiplier<double>(system, 0.0, start.q, start.v, rates);
}

// The multiplier formulation: q' = v, v' = free acceleration + G^-1 (df/dv)^T lambda, 0 = f, and the rows of
// w. For order > 1 the rows of w replace that of v'. The row D^(2-alpha) w = v' lacks the part
// t^(alpha-2)/Gamma(alpha-1) w(0) of v', which is along the reaction: its multiplier is lambda without that
// part.
template <class System, MemoryRows memory>
struct Multiplier {
  static constexpr int n = System::coordinates, r = System::constraints;
  static constexpr int m = memory == MemoryRows::none ? 0 : n;
  static constexpr Layout layout{.q = {0, n}, .v = {n, n}, .w = {2 * n, m}, .lambda = {2 * n + m, r}};
  static constexpr int states = layout.size();
  // The rows that hold w; without memory w = v.
  static constexpr RowBlock memory_rows = memory == MemoryRows::none ? layout.v : layout.w;
  System system;
  InitialState<n> start;

  [[nodiscard]] std::vector<Component> components() const {
    const auto none = zeros<double, n>();
    const auto lambda = initial_multiplier<memory>(system, start);
    if constexpr (memory == MemoryRows::none) {
      return rows(1.0, start.q, 1.0, start.v, 0.0, lambda);
    } else if constexpr (memory == MemoryRows::below_one) {
      return rows(1.0, start.q, 1.0, start.v, 1.0 - system.order, none, 0.0, lambda);
    } else {
      const ConstantConstraint<System> constraint(system, start.q);
      const Vector<double, n> memory_at_start =
          constraint.alignment() == 0.0 ? none : constraint.initial_memory(start.v);
      return rows(1.0, start.q, system.order - 1.0, start.v, 2.0 - system.order, memory_at_start, 0.0,
                  lambda);
    }
  }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = part<layout.q>(y), v = part<layout.v>(y), w = part<memory_rows>(y);
    const Vector<S, r> lambda = part<layout.lambda>(y);
    const auto rates = linearize_constraints<S>(system, S(t), q, v, w);
    const Vector<S, n> acceleration =
        free_acceleration<S>(system, S(t), q, v) +
        raise_index<S>(system, q, Vector<S, n>(rates.velocity_jacobian.transpose() * lambda));
    if constexpr (memory == MemoryRows::none) {
      return stacked<S>(v, acceleration, rates.value);
    } else if constexpr (memory == MemoryRows::below_one) {
      return stacked<S>(v, acceleration, v, rates.value);
    } else {
      return stacked<S>(v, w, acceleration, rates.value);
    }
  }
  [[nodiscard]] OutputValues<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {part<layout.q>(y), part<layout.v>(y), part<memory_rows>(y)};
  }
};

}  // namespace fde::bench::mechanics
