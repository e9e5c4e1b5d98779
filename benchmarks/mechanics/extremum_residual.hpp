// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/reaction.hpp"

namespace fde::bench::mechanics {

// The state and acceleration of a motion at one time.
template <int n>
struct MotionState {
  double t;
  Vector<double, n> q, v, acceleration;
};

// The residual of a motion of the constrained system in the equations of a conditional extremum, a covector:
//   P^T mu (df/dq - d/dt df/dv),
// the factor of the variations delta q = P x, (df/dv) delta q = 0, in Tarasov & Zaslavsky (72). d/dt is along
// q' = v, v' = acceleration; mu' cancels. It is 0 for every mu if f = d/dt phi(t, q). With the index raised
// by the metric, it is the acceleration of the extremum minus that of the motion at the same q, v, mu.
template <class System>
Vector<double, System::coordinates> extremum_residual(const System& system,
                                                      const MotionState<System::coordinates>& at,
                                                      const Vector<double, System::constraints>& mu) {
  static_assert(!HasMemory<System>, "constraints of whole order");
  constexpr int n = System::coordinates, r = System::constraints;
  using Rate = Dual<double, 1>;
  const Vector<Rate, n> velocity = with_velocity<1>(at.v, at.acceleration);
  const auto along = linearize_constraints<Rate>(system, variable<1>(at.t), with_velocity<1>(at.q, at.v),
                                                 velocity, velocity);

  using Slope = Dual<double, n>;
  const Vector<Slope, n> fixed = constants<n>(at.v);
  const Vector<Slope, r> f = constraint_value<Slope>(system, Slope(at.t), variables<n>(at.q), fixed, fixed);

  Vector<double, n> force = Vector<double, n>::Zero();
  for (int i = 0; i < r; ++i) {
    force += mu[i] * derivatives<n>(f[i]);
    for (int j = 0; j < n; ++j) force[j] -= mu[i] * along.velocity_jacobian(i, j).derivative(0);
  }
  const auto rates = linearize_constraints<double>(system, at.t, at.q, at.v, at.v);
  const Reaction<double, System> reaction(system, at.q, rates);
  Vector<double, n> residual;
  for (int j = 0; j < n; ++j)
    residual[j] = force.dot(reaction.projected(Vector<double, n>(Vector<double, n>::Unit(j))));
  return residual;
}

}  // namespace fde::bench::mechanics
