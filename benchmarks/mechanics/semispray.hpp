// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fdebench/benchmarks/mechanics/reaction.hpp"

// Niminet & Blanuta 2009 with T = 1/2 g_ij y^i y^j, without the factor 1/2 of their (2.6) and (2.8). Here y =
// x', systems are autonomous, forces do not depend on the velocity, and constraints are a_sigma(x) y = 0.
namespace fde::bench::mechanics {

// Christoffel symbols of the metric, symbols[i](j, k) = Gamma^i_jk(x):
//   1/2 g^il (dg_lj/dx^k + dg_lk/dx^j - dg_jk/dx^l); 0 without a metric.
template <class S, class System>
std::array<Table<S, System::coordinates, System::coordinates>, System::coordinates> christoffel_symbols(
    const System& system, const Vector<S, System::coordinates>& x) {
  constexpr int n = System::coordinates;
  std::array<Table<S, n, n>, n> symbols;
  symbols.fill(zeros<S, n, n>());
  if constexpr (HasMetric<System>) {
    using D = Dual<S, n>;
    const Table<D, n, n> g = system.template metric<D>(variables<n>(x));
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        Vector<S, n> first_kind;
        for (int l = 0; l < n; ++l) {
          first_kind[l] = 0.5 * (g(l, j).derivative(k) + g(l, k).derivative(j) - g(j, k).derivative(l));
        }
        const Vector<S, n> second_kind = raise_index<S>(system, x, first_kind);
        for (int i = 0; i < n; ++i) symbols.at(static_cast<std::size_t>(i))(j, k) = second_kind[i];
      }
    }
  }
  return symbols;
}

// N^i_j = Gamma^i_jk y^k, the canonical nonlinear connection of the associated Riemannian space.
template <class System>
Table<double, System::coordinates, System::coordinates> riemannian_connection(
    const System& system, const Vector<double, System::coordinates>& x,
    const Vector<double, System::coordinates>& y) {
  constexpr int n = System::coordinates;
  const auto symbols = christoffel_symbols<double>(system, x);
  Table<double, n, n> connection;
  for (int i = 0; i < n; ++i) connection.row(i) = symbols.at(static_cast<std::size_t>(i)) * y;
  return connection;
}

// The multipliers with df/dt = 0; quadratic in y without a force.
struct EnforcingMultipliers {
  template <class S, class System>
  [[nodiscard]] Vector<S, System::constraints> of(const System& system,
                                                  const Vector<S, System::coordinates>& x,
                                                  const Vector<S, System::coordinates>& y) const {
    return enforcing_multiplier<S>(system, S(0.0), x, y, linearize_constraints<S>(system, S(0.0), x, y, y));
  }
};

// Multipliers given as functions of position, lambda(x), for every scalar type.
template <class Function>
struct GivenMultipliers {
  Function lambda;

  template <class S, class System>
  [[nodiscard]] Vector<S, System::constraints> of(const System& /*system*/,
                                                  const Vector<S, System::coordinates>& x,
                                                  const Vector<S, System::coordinates>& /*y*/) const {
    return lambda.template operator()<S>(x);
  }
};
template <class Function>
GivenMultipliers(Function) -> GivenMultipliers<Function>;

// The coefficients 2 G*^i(x, y) = Gamma^i_jk y^j y^k - (F^i + lambda^sigma a_sigma^i) of the canonical
// semispray y d/dx - 2 G* d/dy. Its integral curves y' = -2 G* are the evolution curves (theorem 2.3). F
// includes the force of the potential.
template <class S, class System, class Multipliers>
Vector<S, System::coordinates> semispray(const System& system, const Multipliers& multipliers,
                                         const Vector<S, System::coordinates>& x,
                                         const Vector<S, System::coordinates>& y) {
  constexpr int n = System::coordinates;
  Vector<S, n> force = applied_force<S>(system, S(0.0), x, y);
  const auto rates = linearize_constraints<S>(system, S(0.0), x, y, y);
  const Vector<S, System::constraints> lambda = multipliers.template of<S>(system, x, y);
  force += rates.velocity_jacobian.transpose() * lambda;
  Vector<S, n> coefficients = -raise_index<S>(system, x, force);
  const auto symbols = christoffel_symbols<S>(system, x);
  for (int i = 0; i < n; ++i) {
    const Vector<S, n> connected = symbols.at(static_cast<std::size_t>(i)) * y;
    coefficients[i] += y.dot(connected);
  }
  return coefficients;
}

// N*^i_j = dG*^i/dy^j, the nonlinear connection of the semispray.
template <class System, class Multipliers>
Table<double, System::coordinates, System::coordinates> semispray_connection(
    const System& system, const Multipliers& multipliers, const Vector<double, System::coordinates>& x,
    const Vector<double, System::coordinates>& y) {
  constexpr int n = System::coordinates;
  using D = Dual<double, n>;
  const Vector<D, n> coefficients = semispray<D>(system, multipliers, constants<n>(x), variables<n>(y));
  Table<double, n, n> connection;
  for (int i = 0; i < n; ++i) connection.row(i) = 0.5 * derivatives<n>(coefficients[i]).transpose();
  return connection;
}

}  // namespace fde::bench::mechanics
