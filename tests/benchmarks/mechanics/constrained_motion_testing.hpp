// SPDX-License-Identifier: MIT
#pragma once

// Motions q'' = -k q - g + a lambda, componentwise, under a.q' + b.D^alpha q = a.q'(0), as linear systems.

#include <array>

#include "support/linear_system_testing.hpp"

namespace fde::bench {

struct Motion {
  const char* name = "";
  double alpha = 0.5, rest = 0.5;  // rest = 1 - alpha as a decimal, which the difference of doubles is not
  std::array<double, 2> k{1.0, 2.0}, g{0.5, -1.0}, a{1.0, 2.0}, b{0.5, -0.3}, q0{0.7, -0.2}, v0{0.2, -0.1};
};

enum class OutputChoice { positions_and_memory, velocities_and_memory };
inline constexpr std::size_t multiplier_component = 8;

inline std::vector<double> initial_of(double order, double value) {
  return order == 0.0 ? std::vector<double>{} : std::vector{value};
}

// Components q, v, w, e, lambda with e = v(0); the caller adds the rows of w.
inline reference::LinearSystem without_memory(const Motion& m) {
  reference::LinearSystem system{.orders = {1, 1, 1, 1, 0, 0, 1, 1, 0},
                                 .initial = std::vector<std::vector<double>>(9),
                                 .matrix = Matrix::Zero(9, 9),
                                 .loads = std::vector<std::vector<reference::Load>>(9)};
  system.matrix(8, 8) = 1.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    system.initial[i] = {m.q0[i]};
    system.initial[2 + i] = system.initial[6 + i] = {m.v0[i]};
    system.matrix(k, 2 + k) = 1.0;
    system.matrix.row(8)(2 + k) = m.a[i];
    system.matrix.row(8)(4 + k) = m.b[i];
    system.matrix.row(8)(6 + k) = -m.a[i];
  }
  return system;
}

// Adds -k q - g + a lambda to the rows first_row and first_row + 1, one for each coordinate.
inline void add_forces(reference::LinearSystem& system, const Motion& m, std::size_t first_row) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto row = static_cast<Eigen::Index>(first_row + i);
    system.matrix(row, static_cast<Eigen::Index>(i)) = -m.k[i];
    system.matrix(row, multiplier_component) = m.a[i];
    system.loads[first_row + i] = {{-m.g[i]}};
  }
}

// v' = forces, D^(1-alpha) w = v.
inline reference::LinearSystem with_multiplier(const Motion& m, OutputChoice shown) {
  reference::LinearSystem system = without_memory(m);
  add_forces(system, m, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    system.orders[4 + i] = m.rest;
    system.initial[4 + i] = initial_of(m.rest, 0.0);
    system.matrix(4 + k, 2 + k) = 1.0;
  }
  system.outputs = shown == OutputChoice::positions_and_memory ? std::vector<std::size_t>{0, 1, 4, 5}
                                                               : std::vector<std::size_t>{2, 3, 4, 5};
  return system;
}

// 1 < alpha < 2: D^(alpha-1) v = w, D^(2-alpha) w = forces. Outputs q, v, w.
inline reference::LinearSystem with_multiplier_above_one(const Motion& m, double above, double below) {
  reference::LinearSystem system = without_memory(m);
  add_forces(system, m, 4);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    system.orders[2 + i] = above;
    system.orders[4 + i] = below;
    system.initial[4 + i] = {0.0};
    system.matrix(2 + k, 4 + k) = 1.0;
  }
  system.outputs = {0, 1, 2, 3, 4, 5};
  return system;
}

// D^alpha p = w, 0 = p - q: components 9 and 10 are p. Outputs q, w.
inline reference::LinearSystem with_memory_on_copies(const Motion& m) {
  reference::LinearSystem system = without_memory(m);
  add_forces(system, m, 2);
  system.matrix.conservativeResizeLike(Matrix::Zero(11, 11));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    system.orders.push_back(m.alpha);
    system.initial.push_back({m.q0[i]});
    if (m.alpha > 1.0) system.initial.back().push_back(m.v0[i]);
    system.loads.emplace_back();
    system.matrix(9 + k, 4 + k) = 1.0;
    system.matrix(4 + k, 4 + k) = 1.0;
    system.matrix(4 + k, 9 + k) = 1.0;
    system.matrix(4 + k, k) = -1.0;
  }
  system.outputs = {0, 1, 4, 5};
  return system;
}

// q' = z - A w, z' = -P (k q + g), D^(1-alpha) w = z - A w, for the default a, b, k and g, for which A, P and
// their products are short decimals, or with b = 0. Outputs: all components q, z, w.
inline reference::LinearSystem integrated_form(const Motion& m) {
  Matrix a_b = (Matrix(2, 2) << 0.1, -0.06, 0.2, -0.12).finished();
  if (m.b[0] == 0.0) a_b.setZero();
  reference::LinearSystem system{.orders = {1, 1, 1, 1, m.rest, m.rest},
                                 .initial = {{m.q0[0]}, {m.q0[1]}, {m.v0[0]}, {m.v0[1]}, {0.0}, {0.0}},
                                 .matrix = Matrix::Zero(6, 6),
                                 .loads = {{}, {}, {{-0.8}}, {{0.4}}, {}, {}}};
  for (const Eigen::Index row : {0, 4}) {
    system.matrix.block(row, 2, 2, 2).setIdentity();
    system.matrix.block(row, 4, 2, 2) = -a_b;
  }
  system.matrix.block(2, 0, 2, 2) << -0.8, 0.8, 0.4, -0.4;
  return system;
}

}  // namespace fde::bench
