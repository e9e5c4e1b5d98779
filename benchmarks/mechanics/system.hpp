// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "fdebench/benchmarks/mechanics/dual_derivatives.hpp"

namespace fde::bench::mechanics {

// A mechanical system is a type with
//   static constexpr int coordinates, constraints;
//   template <class S> Vector<S, constraints> constraint(t, q, v) const;      or, with memory,
//   template <class S> Vector<S, constraints> constraint(t, q, v, w) const;   w = D^order q, and
//   double order;                                                             in (0, 2)
// and, optionally,
//   template <class S> S potential(q) const;                                  u
//   template <class S> Table<S, n, n> metric(q) const;                        G, else the identity;
//                                                                             or Diagonal<S, n>
//   template <class S> Vector<S, n> force(t, q, v) const;                     F, covariant
// for every scalar S that automatic differentiation needs: t is an S, q, v and w are Vector<S, n>. Absent
// functions cost nothing. The Lagrangian is 1/2 v'G v - u, the constraints are f(t, q, v, w) = 0.

template <class System>
concept HasPotential = requires(const System& s, const Vector<double, System::coordinates>& q) {
  s.template potential<double>(q);
};
template <class System>
concept HasMetric = requires(const System& s, const Vector<double, System::coordinates>& q) {
  s.template metric<double>(q);
};
template <class System>
concept HasForce = requires(const System& s, const Vector<double, System::coordinates>& q) {
  s.template force<double>(0.0, q, q);
};
template <class System>
concept HasMemory = requires(const System& s, const Vector<double, System::coordinates>& q) {
  s.template constraint<double>(0.0, q, q, q);
};

// A system whose equations are all linear in q, v, w declares static constexpr bool linear = true.
template <class System>
concept Linear = requires {
  requires std::remove_cvref_t<System>::linear;
};

// f(t, q, v, w); w is ignored if the constraint does not depend on it.
template <class S, class System>
Vector<S, System::constraints> constraint_value(const System& system, const S& t,
                                                const Vector<S, System::coordinates>& q,
                                                const Vector<S, System::coordinates>& v,
                                                const Vector<S, System::coordinates>& w) {
  if constexpr (HasMemory<System>) {
    return system.template constraint<S>(t, q, v, w);
  } else {
    return system.template constraint<S>(t, q, v);
  }
}

// G(q)^-1 x.
template <class S, class System, class Columns>
auto raise_index(const System& system, const Vector<S, System::coordinates>& q, const Columns& x) {
  using Result = Table<S, System::coordinates, Columns::ColsAtCompileTime>;
  if constexpr (HasMetric<System>) {
    return Result(system.template metric<S>(q).inverse() * x);
  } else {
    return Result(x);
  }
}

// The terms of d/dt (G v) - 1/2 grad (v'G v) except G v': Christoffel symbols of the first kind times v v,
//   c_i = sum_jk (dG_ij/dq_k - 1/2 dG_jk/dq_i) v_j v_k = sum_k (dp_i/dq_k - 1/2 dp_k/dq_i) v_k
// with the momenta p = G v at fixed v.
template <class S, HasMetric System>
Vector<S, System::coordinates> christoffel_terms(const System& system,
                                                 const Vector<S, System::coordinates>& q,
                                                 const Vector<S, System::coordinates>& v) {
  constexpr int n = System::coordinates;
  using D = Dual<S, n>;
  const Vector<D, n> momenta = system.template metric<D>(variables<n>(q)) * constants<n>(v);
  auto terms = zeros<S, n>();
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k)
      terms[i] += (momenta[i].derivative(k) - 0.5 * momenta[k].derivative(i)) * v[k];
  }
  return terms;
}

// -grad u + F, covariant.
template <class S, class System>
Vector<S, System::coordinates> applied_force(const System& system, [[maybe_unused]] const S& t,
                                             [[maybe_unused]] const Vector<S, System::coordinates>& q,
                                             [[maybe_unused]] const Vector<S, System::coordinates>& v) {
  constexpr int n = System::coordinates;
  auto force = zeros<S, n>();
  if constexpr (HasPotential<System>) {
    using D = Dual<S, n>;
    const D potential = system.template potential<D>(variables<n>(q));
    force -= derivatives<n>(potential);
  }
  if constexpr (HasForce<System>) force += system.template force<S>(t, q, v);
  return force;
}

// v' without constraints: G^-1 (-grad u + F - Christoffel terms).
template <class S, class System>
Vector<S, System::coordinates> free_acceleration(const System& system, const S& t,
                                                 const Vector<S, System::coordinates>& q,
                                                 const Vector<S, System::coordinates>& v) {
  Vector<S, System::coordinates> force = applied_force<S>(system, t, q, v);
  if constexpr (HasMetric<System>) force -= christoffel_terms<S>(system, q, v);
  return raise_index<S>(system, q, force);
}

}  // namespace fde::bench::mechanics
