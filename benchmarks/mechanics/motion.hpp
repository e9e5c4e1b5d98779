// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "fdebench/benchmarks/mechanics/dual_derivatives.hpp"
#include "fdebench/benchmarks/mechanics/layout.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench::mechanics {

// Coordinates and velocities at t = 0.
template <int n>
struct InitialState {
  Vector<double, n> q, v;
};

// The output columns of a formulation: coordinates, velocities, D^order q.
template <int n>
struct OutputValues {
  Vector<double, n> q, v, w;
};

// `sum`, or 0 if |sum| is within rounding of `size`, the sum of the absolute values of its terms.
inline double zero_if_rounding(double sum, double size) {
  return std::abs(sum) <= 4.0 * std::numeric_limits<double>::epsilon() * size ? 0.0 : sum;
}

// The concatenation of vectors.
template <class S, class... Parts>
auto stacked(const Parts&... parts) {
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

// Components in blocks: arguments are pairs of an order and the initial values of all components of that
// order.
template <class... Groups>
std::vector<Component> rows(const Groups&... groups) {
  std::vector<Component> components;
  add_rows(components, groups...);
  return components;
}

}  // namespace fde::bench::mechanics
