// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/mechanics/reaction.hpp"
#include "fdebench/schemes/problem/linear_smoothness.hpp"

// The formulations acceleration and stabilised: v' = free acceleration + the reaction that gives df/dt +
// kappa f = 0; kappa = 0 is the printed form.
namespace fde::bench::mechanics {

// Constraints without memory, f(t, q, v) = 0, or f(t, q, v, w) = 0 at order 1, where w = v: equations for q'
// = v and v'. The reaction is along df/dv only, not along df/dw.
template <class System>
struct AccelerationWithoutMemory {
  static constexpr int n = System::coordinates;
  static constexpr Layout layout{.q = {0, n}, .v = {n, n}};
  static constexpr int states = layout.size();
  System system;
  InitialState<n> start;
  double kappa;

  [[nodiscard]] std::vector<Component> components() const { return rows(1.0, start.q, 1.0, start.v); }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = part<layout.q>(y), v = part<layout.v>(y);
    const auto rates = linearize_constraints<S>(system, S(t), q, v, v);
    const Reaction<S, System> reaction(system, q, rates);
    const Vector<S, n> free = free_acceleration<S>(system, S(t), q, v);
    Vector<S, System::constraints> defect = rates.acceleration_jacobian * free + rates.convective_rate;
    if (kappa != 0.0) defect += S(kappa) * rates.value;
    return stacked<S>(v, Vector<S, n>(free + reaction.compensating_acceleration(defect)));
  }
  [[nodiscard]] OutputValues<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {part<layout.q>(y), part<layout.v>(y), part<layout.v>(y)};
  }
};

// The direction of the unbounded part of v' at t = 0, which is direction t^-alpha / Gamma(1-alpha); it is due
// to w' = D^alpha v + t^-alpha / Gamma(1-alpha) v(0) (Tarasov & Zaslavsky 23). (df/dw) v(0) within rounding
// of 0 counts as 0.
template <class System>
Vector<double, System::coordinates> singular_direction(const System& system,
                                                       const InitialState<System::coordinates>& start) {
  const auto none = zeros<double, System::coordinates>();
  const auto rates = linearize_constraints<double>(system, 0.0, start.q, start.v, none);
  Vector<double, System::constraints> moved = rates.memory_jacobian * start.v;
  const Vector<double, System::constraints> size = rates.memory_jacobian.cwiseAbs() * start.v.cwiseAbs();
  for (int i = 0; i < System::constraints; ++i) moved[i] = zero_if_rounding(moved[i], size[i]);
  return Reaction<double, System>(system, start.q, rates).compensating_acceleration(moved);
}

// 0 < alpha < 1: q' = v, D^alpha v = s, D^(1-alpha) s = v' as above, D^(1-alpha) w = v; equations 37 and 42
// as printed for kappa = 0. With c = singular_direction, s has the term c t^(1-2 alpha) / Gamma(2-2 alpha),
// which is subtracted from the state. The remainder of s starts like t^(2-3 alpha); the right-hand side of
// its row, v' without c t^-alpha / Gamma(1-alpha), starts like t^(1-2 alpha). So the form is well posed for
// alpha < 1/2 only.
template <class System>
struct AccelerationBelowOne {
  static constexpr int n = System::coordinates;
  static constexpr Layout layout{.q = {0, n}, .v = {n, n}, .s = {2 * n, n}, .w = {3 * n, n}};
  static constexpr int states = layout.size();
  System system;
  InitialState<n> start;
  double kappa;
  Vector<double, n> singular = singular_direction(system, start);

  [[nodiscard]] std::vector<Component> components() const {
    const auto none = zeros<double, n>();
    const double alpha = system.order;
    return rows(1.0, start.q, alpha, start.v, 1.0 - alpha, none, 1.0 - alpha, none);
  }
  [[nodiscard]] bool is_well_posed() const { return singular.isZero(0.0) || system.order < 0.5; }

  [[nodiscard]] std::vector<PowerLoad> loads() const {
    const double alpha = system.order;
    if (singular.isZero(0.0)) return {};
    Vec coefficients = Vec::Zero(layout.size());
    part<layout.v>(coefficients) = singular / std::tgamma(2.0 - 2.0 * alpha);
    return {{1.0 - 2.0 * alpha, coefficients}};
  }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = part<layout.q>(y), v = part<layout.v>(y), w = part<layout.w>(y);
    const double alpha = system.order;
    Vector<S, n> s = part<layout.s>(y);
    if (!singular.isZero(0.0))
      s += converted_to<S, n>(singular * (std::pow(t, 1.0 - 2.0 * alpha) / std::tgamma(2.0 - 2.0 * alpha)));
    const auto rates = linearize_constraints<S>(system, S(t), q, v, w);
    const Reaction<S, System> reaction(system, q, rates);
    const Vector<S, n> free = free_acceleration<S>(system, S(t), q, v);
    Vector<S, System::constraints> defect =
        rates.acceleration_jacobian * free + rates.convective_rate + rates.memory_jacobian * s;
    if (kappa != 0.0) defect += S(kappa) * rates.value;
    Vector<S, n> acceleration = free + reaction.compensating_acceleration(defect);
    if (t > 0.0 && !start.v.isZero(0.0)) {
      const Vector<S, System::constraints> started = rates.memory_jacobian * converted_to<S, n>(start.v);
      acceleration += (reaction.compensating_acceleration(started) - converted_to<S, n>(singular)) *
                      S(std::pow(t, -alpha) / std::tgamma(1.0 - alpha));
    }
    return stacked<S>(v, s, acceleration, v);
  }
  [[nodiscard]] OutputValues<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {part<layout.q>(y), part<layout.v>(y), part<layout.w>(y)};
  }
};

}  // namespace fde::bench::mechanics
