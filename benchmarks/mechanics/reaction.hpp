// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/system.hpp"

namespace fde::bench::mechanics {

// The constraints and their first derivatives at (t, q, v, w).
template <class S, class System>
struct ConstraintLinearization {
  static constexpr int n = System::coordinates, r = System::constraints;
  Vector<S, r> value;  // f
  // df/dv: the reaction force is its transpose times lambda (Chetaev; Tarasov & Zaslavsky 32).
  Table<S, r, n> velocity_jacobian;
  // The factor of v' in df/dt: df/dv; at order 1, where w = v, df/dv + df/dw.
  Table<S, r, n> acceleration_jacobian;
  Table<S, r, n> memory_jacobian;  // df/dw; zero at order 1
  Vector<S, r> convective_rate;    // df/dt + (df/dq) v
};

template <class S, class System>
ConstraintLinearization<S, System> linearize_constraints(const System& system, const S& t,
                                                         const Vector<S, System::coordinates>& q,
                                                         const Vector<S, System::coordinates>& v,
                                                         const Vector<S, System::coordinates>& w) {
  constexpr int n = System::coordinates, r = System::constraints;
  constexpr int directions = HasMemory<System> ? 2 * n + 1 : n + 1, along = directions - 1;
  using D = Dual<S, directions>;
  const D time = variable<directions>(t, along);
  const Vector<D, n> rates = variables<directions>(v);
  const auto memory = [&]() -> Vector<D, n> {
    if constexpr (HasMemory<System>) {
      return variables<directions>(w, n);
    } else {
      return variables<directions>(v);
    }
  }();
  const Vector<D, r> f =
      constraint_value<D>(system, time, with_velocity<directions>(q, v, along), rates, memory);
  ConstraintLinearization<S, System> result;
  for (int i = 0; i < r; ++i) {
    result.value[i] = f[i].value();
    result.convective_rate[i] = f[i].derivative(along);
    for (int j = 0; j < n; ++j) {
      result.velocity_jacobian(i, j) = f[i].derivative(j);
      if constexpr (HasMemory<System>) result.memory_jacobian(i, j) = f[i].derivative(n + j);
    }
  }
  result.acceleration_jacobian = result.velocity_jacobian;
  if constexpr (HasMemory<System>) {
    if (system.order == 1.0) {
      result.acceleration_jacobian += result.memory_jacobian;
      result.memory_jacobian = zeros<S, r, n>();
    }
  }
  return result;
}

// The reaction of the constraints. For df/dt = A v' + x, with A the acceleration_jacobian and R = df/dv the
// velocity_jacobian, the acceleration
//   -G^-1 R^T (A G^-1 R^T)^-1 x                                                    (Tarasov & Zaslavsky 36)
// compensates the defect x.
template <class S, class System>
class Reaction {
  static constexpr int n = System::coordinates, r = System::constraints;

 public:
  Reaction(const System& system, const Vector<S, n>& q, const ConstraintLinearization<S, System>& rates)
      : acceleration_jacobian_(rates.acceleration_jacobian),
        directions_(raise_index<S>(system, q, Table<S, n, r>(rates.velocity_jacobian.transpose()))),
        inverse_(Table<S, r, r>(acceleration_jacobian_ * directions_).inverse()) {}

  [[nodiscard]] Vector<S, r> multiplier(const Vector<S, r>& defect) const { return -(inverse_ * defect); }
  [[nodiscard]] Vector<S, n> compensating_acceleration(const Vector<S, r>& defect) const {
    return directions_ * multiplier(defect);
  }
  // The projection of x along the reaction, with A (projected x) = 0.
  [[nodiscard]] Vector<S, n> projected(const Vector<S, n>& x) const {
    const Vector<S, r> component = acceleration_jacobian_ * x;
    return x + compensating_acceleration(component);
  }

 private:
  Table<S, r, n> acceleration_jacobian_;
  Table<S, n, r> directions_;
  Table<S, r, r> inverse_;
};

// The multiplier with df/dt = 0, for constraints without a term in w'.
template <class S, class System>
Vector<S, System::constraints> enforcing_multiplier(const System& system, const S& t,
                                                    const Vector<S, System::coordinates>& q,
                                                    const Vector<S, System::coordinates>& v,
                                                    const ConstraintLinearization<S, System>& rates) {
  const Reaction<S, System> reaction(system, q, rates);
  return reaction.multiplier(rates.acceleration_jacobian * free_acceleration<S>(system, t, q, v) +
                             rates.convective_rate);
}

}  // namespace fde::bench::mechanics
