// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/memory_rows.hpp"
#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/mechanics/projection.hpp"

namespace fde::bench::mechanics {

// The integrated formulation, for constraints that are affine in the velocity, f = a(t, q) v + beta(t, q, w)
// (Tarasov & Zaslavsky 38), with alpha up to 1:
//   q' = v = P z - a^# beta,  z' = P (free acceleration) + P' v,  and the row of w, w(0) = 0,
// with the projector P = I - a^# a, a^# = G^-1 R^T (a G^-1 R^T)^-1, R = df/dv. z(0) = P v(0). For constant a
// and f = a.v + b.w - C0 this is q' = z - A w, z' = -P grad u with A = a b^T/|a|^2, and no term is singular.
template <class System, MemoryRows memory>
struct Integrated {
  static_assert(memory != MemoryRows::above_one);
  static constexpr int n = System::coordinates, m = memory == MemoryRows::none ? 0 : n;
  static constexpr Layout layout{.q = {0, n}, .z = {n, n}, .w = {2 * n, m}};
  static constexpr int states = layout.size();
  System system;
  InitialState<n> start;

  [[nodiscard]] std::vector<Component> components() const {
    const auto none = zeros<double, n>();
    const Vector<double, n> free_part =
        Projection<double, System>(system, 0.0, start.q, none).project(start.v);
    if constexpr (memory == MemoryRows::none) {
      return rows(1.0, start.q, 1.0, free_part);
    } else {
      return rows(1.0, start.q, 1.0, free_part, 1.0 - system.order, none);
    }
  }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = part<layout.q>(y), z = part<layout.z>(y);
    const Projection<S, System> projection(system, S(t), q, memory_of_state<S>(y));
    const Vector<S, n> v = projection.velocity(z), free = free_acceleration<S>(system, S(t), q, v);
    const Vector<S, n> turned = projection_rate<S>(system, S(t), q, v);
    return stacked<S>(v, Vector<S, n>(projection.project(free) + turned), Vector<S, m>(v.template head<m>()));
  }
  [[nodiscard]] OutputValues<n> columns(double t, const Vector<double, states>& y) const {
    const Vector<double, n> q = part<layout.q>(y), z = part<layout.z>(y), w = memory_of_state<double>(y);
    const Vector<double, n> v = Projection<double, System>(system, t, q, w).velocity(z);
    return {q, v, memory == MemoryRows::none ? v : w};
  }

 private:
  // w, or 0 if the constraint does not depend on it beside v.
  template <class S>
  static Vector<S, n> memory_of_state(const Vector<S, states>& y) {
    if constexpr (memory == MemoryRows::none) {
      return zeros<S, n>();
    } else {
      return part<layout.w>(y);
    }
  }
};

}  // namespace fde::bench::mechanics
