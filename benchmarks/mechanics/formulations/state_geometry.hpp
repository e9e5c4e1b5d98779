#pragma once

#include <string>
#include <vector>

#include "mechanics/motion.hpp"
#include "mechanics/semispray.hpp"
#include "scenes/scene.hpp"

namespace fde::mechanics {

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

template <class System>
StateGeometry geometry_of(const System& system, const std::vector<std::string>& coordinates,
                          const Motion<System::coordinates>& start) {
  using Point = Vector<double, System::coordinates>;
  return {coordinates, start.q, start.v,
          [system](In q, In v) { return geometry_at(system, Point(q), Point(v)); }};
}

}  // namespace fde::mechanics
