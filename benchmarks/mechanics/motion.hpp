#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "mechanics/derivatives.hpp"
#include "mechanics/layout.hpp"
#include "problem/problem.hpp"

namespace fde::mechanics {

// Coordinates and velocities at t = 0.
template <int n>
struct Motion {
  Vector<double, n> q, v;
};

// What a formulation's state says: coordinates, velocities, D^order q.
template <int n>
struct Columns {
  Vector<double, n> q, v, w;
};

// A sum of terms that have this size together, or 0 where it is what rounding leaves of 0.
inline double unless_rounding(double sum, double size) {
  return std::abs(sum) <= 4.0 * std::numeric_limits<double>::epsilon() * size ? 0.0 : sum;
}

// Vectors under one another.
template <class S, class... Parts>
auto joined(const Parts&... parts) {
  Vector<S, (int{Parts::RowsAtCompileTime} + ...)> result;
  int next = 0;
  const auto append = [&](const auto& part) {
    for (int i = 0; i < part.RowsAtCompileTime; ++i) result[next++] = part[i];
  };
  (append(parts), ...);
  return result;
}

inline void add_rows(std::vector<Component>& /*components*/) {}
template <class Initial, class... Rest>
void add_rows(std::vector<Component>& components, double order, const Initial& initial, const Rest&... rest) {
  for (const double value : initial) components.push_back({order, {value}});
  add_rows(components, rest...);
}

// Components in groups: an order and the initial values of all that have it, and so on.
template <class... Groups>
std::vector<Component> rows(const Groups&... groups) {
  std::vector<Component> components;
  add_rows(components, groups...);
  return components;
}

}  // namespace fde::mechanics
