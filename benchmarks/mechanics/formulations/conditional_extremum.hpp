// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"

namespace fde::bench::mechanics {

// The conditional extremum of the action int (L + mu f) dt, for constraints f = a(t, q) v + beta(t, q):
// Tarasov & Zaslavsky (67). It differs from the motion of the constrained system, whose equations contain no
// derivative of the multiplier. With the momenta p = G v + a^T mu
//   q' = v = G^-1 (p - a^T mu),   p' = d/dq (1/2 v'G v - u + mu f) at fixed v and mu,
// and f = 0 gives mu = (a G^-1 a^T)^-1 (a G^-1 p + beta). The state is q, p.
template <class System>
struct ConditionalExtremum {
  static_assert(!HasForce<System> && !HasMemory<System>,
                "an action of potentials, constraints of whole order");
  static constexpr int n = System::coordinates, r = System::constraints;
  static constexpr Layout layout{.q = {0, n}, .p = {n, n}};
  static constexpr int states = layout.size();
  System system;
  InitialState<n> start;
  Vector<double, r> multiplier;  // mu(0)

  template <class S>
  struct Velocity {
    Vector<S, n> v;
    Vector<S, r> mu;
  };

  template <class S>
  [[nodiscard]] Velocity<S> velocity(double t, const Vector<S, n>& q, const Vector<S, n>& p) const {
    const auto none = zeros<S, n>();
    const auto rates = linearize_constraints<S>(system, S(t), q, none, none);
    const Reaction<S, System> reaction(system, q, rates);
    const Vector<S, n> free = raise_index<S>(system, q, p);
    const Vector<S, r> defect = rates.acceleration_jacobian * free + rates.value;
    return {free + reaction.compensating_acceleration(defect), -reaction.multiplier(defect)};
  }

  [[nodiscard]] std::vector<Component> components() const {
    Vector<double, n> p = start.v;
    if constexpr (HasMetric<System>) p = system.template metric<double>(start.q) * p;
    p += linearize_constraints<double>(system, 0.0, start.q, start.v, start.v).velocity_jacobian.transpose() *
         multiplier;
    return rows(1.0, start.q, 1.0, p);
  }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    using D = Dual<S, n>;
    const Vector<S, n> q = part<layout.q>(y), p = part<layout.p>(y);
    const Velocity<S> at = velocity<S>(t, q, p);
    const Vector<D, n> place = variables<n>(q), v = constants<n>(at.v);
    D action(0.0);
    if constexpr (HasMetric<System>) action += 0.5 * v.dot(system.template metric<D>(place) * v);
    if constexpr (HasPotential<System>) action -= system.template potential<D>(place);
    const Vector<D, r> f = constraint_value<D>(system, D(t), place, v, v);
    for (int i = 0; i < r; ++i) action += at.mu[i] * f[i];
    return stacked<S>(at.v, derivatives<n>(action));
  }
  [[nodiscard]] OutputValues<n> columns(double t, const Vector<double, states>& y) const {
    const Vector<double, n> q = part<layout.q>(y);
    const Vector<double, n> v = velocity<double>(t, q, part<layout.p>(y)).v;
    return {q, v, v};
  }
};

// The scene of the conditional extremum of a setting; mu: the multipliers at t = 0.
template <class System>
Scene extremum_scene(const MechanicalSetup<System>& of, const Vector<double, System::constraints>& mu) {
  Scene scene;
  auto form = make_problem(ConditionalExtremum<System>{of.system, of.start, mu}, of.end);
  scene.problem = std::move(form.problem);
  scene.smoothness = std::move(form.smoothness);
  scene.outputs = {column_names(of.coordinates, false), std::move(form.columns)};
  scene.energy = energy_of(of.system);
  scene.constraint = constraint_of(of.system);
  return scene;
}

}  // namespace fde::bench::mechanics
