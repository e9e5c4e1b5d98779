// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/mechanics/semispray.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench::mechanics {

// The geometry of a system at q, v. Forces and constraints are evaluated at t = 0.
template <class System>
Geometry geometry_at(const System& system, const Vector<double, System::coordinates>& q,
                     const Vector<double, System::coordinates>& v) {
  constexpr int n = System::coordinates;
  Geometry geometry{.metric = Matrix::Identity(n, n),
                    .christoffel = {},
                    .connection = riemannian_connection(system, q, v),
                    .semispray = -free_acceleration<double>(system, 0.0, q, v),
                    .multipliers = {},
                    .constrained_semispray = {},
                    .constrained_connection = {}};
  if constexpr (HasMetric<System>) geometry.metric = Table<double, n, n>(system.template metric<double>(q));
  for (const auto& symbols : christoffel_symbols<double>(system, q))
    geometry.christoffel.emplace_back(symbols);
  if constexpr (!HasMemory<System>) {
    constexpr EnforcingMultipliers enforcing;
    geometry.multipliers = enforcing.of<double>(system, q, v);
    geometry.constrained_semispray = semispray<double>(system, enforcing, q, v);
    geometry.constrained_connection = semispray_connection(system, enforcing, q, v);
  }
  return geometry;
}

// f(0, q, v) = 0 by Newton's method, each step of which goes along the reaction.
template <class System>
Vec allowed_velocity(const System& system, const Vector<double, System::coordinates>& q,
                     Vector<double, System::coordinates> v) {
  constexpr int most_steps = 50;
  constexpr double rounding = 1e-15;
  for (int i = 0; i < most_steps; ++i) {
    const auto rates = linearize_constraints<double>(system, 0.0, q, v, v);
    const Vector<double, System::coordinates> step =
        Reaction<double, System>(system, q, rates).compensating_acceleration(rates.value);
    v += step;
    if (!(step.norm() > rounding * v.norm())) break;
  }
  return v;
}

template <class System>
StateGeometry geometry_of(const System& system, const std::vector<std::string>& coordinates,
                          const InitialState<System::coordinates>& start) {
  using Point = Vector<double, System::coordinates>;
  StateGeometry geometry{coordinates, start.q, start.v,
                         [system](In q, In v) { return geometry_at(system, Point(q), Point(v)); }};
  if constexpr (!HasMemory<System>)
    geometry.allowed = [system](In q, In v) { return allowed_velocity(system, Point(q), Point(v)); };
  return geometry;
}

}  // namespace fde::bench::mechanics
