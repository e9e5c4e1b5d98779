// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/reaction.hpp"

namespace fde::bench::mechanics {

// For constraints that are affine in the velocity, f = a(t, q) v + beta(t, q, w): the projection onto
// velocities with a v = 0, and the velocity that satisfies f = 0.
template <class S, class System>
class Projection {
  static constexpr int n = System::coordinates;

 public:
  Projection(const System& system, const S& t, const Vector<S, n>& q, const Vector<S, n>& w)
      : rates_(linearize_constraints<S>(system, t, q, zeros<S, n>(), w)), reaction_(system, q, rates_) {}

  // P x, with a P = 0 and P G^-1 (df/dv)^T = 0.
  [[nodiscard]] Vector<S, n> project(const Vector<S, n>& x) const { return reaction_.projected(x); }
  // The velocity with f = 0 and P v = P z.
  [[nodiscard]] Vector<S, n> velocity(const Vector<S, n>& z) const {
    return project(z) + reaction_.compensating_acceleration(rates_.value);
  }
  [[nodiscard]] const ConstraintLinearization<S, System>& rates() const { return rates_; }
  [[nodiscard]] const Reaction<S, System>& reaction() const { return reaction_; }

 private:
  ConstraintLinearization<S, System> rates_;
  Reaction<S, System> reaction_;
};

// P' v along a motion with velocity v, the contribution of the changing constraint directions.
template <class S, class System>
Vector<S, System::coordinates> projection_rate(const System& system, const S& t,
                                               const Vector<S, System::coordinates>& q,
                                               const Vector<S, System::coordinates>& v) {
  constexpr int n = System::coordinates;
  using D = Dual<S, 1>;
  const Projection<D, System> turning(system, variable<1>(t), with_velocity<1>(q, v), zeros<D, n>());
  const Vector<D, n> projected = turning.project(constants<1>(v));
  Vector<S, n> rate;
  for (int i = 0; i < n; ++i) rate[i] = projected[i].derivative(0);
  return rate;
}

}  // namespace fde::bench::mechanics
