#pragma once

#include <cmath>
#include <limits>

#include "linear_smoothness.hpp"
#include "motion.hpp"
#include "projection.hpp"

// The formulations of constraints f(t, q, v, w) = 0 with w = D^alpha q, 0 < alpha < 1. All have the row
// D^(1-alpha) w = v, w(0) = 0.
namespace fde::mechanics {

// The part of v' that w' = D^alpha v + t^-alpha / Gamma(1-alpha) v(0) (Tarasov & Zaslavsky 23) makes
// unbounded at 0: direction t^-alpha / Gamma(1-alpha), taken at t = 0. What is rounding of (df/dw) v(0) is 0.
template <class System>
Vector<double, System::coordinates> singular_direction(const System& system,
                                                       const Motion<System::coordinates>& start) {
  const Vector<double, System::coordinates> none = Vector<double, System::coordinates>::Zero();
  const auto rates = constraint_rates<double>(system, 0.0, start.q, start.v, none);
  Vector<double, System::constraints> moved = rates.memory * start.v;
  const Vector<double, System::constraints> size = rates.memory.cwiseAbs() * start.v.cwiseAbs();
  for (int i = 0; i < System::constraints; ++i) {
    if (std::abs(moved[i]) <= 4.0 * std::numeric_limits<double>::epsilon() * size[i]) moved[i] = 0.0;
  }
  return Reaction<double, System>(system, start.q, rates).answer(moved);
}

// q' = v, D^alpha v = s, D^(1-alpha) s = v' = free acceleration + reaction to df/dt + kappa f = 0: equations
// 37 and 42 as printed for kappa = 0. With c = singular_direction s has the part c t^(1-2 alpha) /
// Gamma(2-2 alpha), which is kept out of the state: it is bounded for alpha < 1/2 only.
template <class System>
struct AccelerationBelowOne {
  static constexpr int n = System::coordinates, states = 4 * n;
  System system;
  Motion<n> start;
  double kappa;
  Vector<double, n> singular = singular_direction(system, start);

  [[nodiscard]] std::vector<Component> components() const {
    const Vector<double, n> none = Vector<double, n>::Zero();
    const double alpha = system.order;
    return rows(1.0, start.q, alpha, start.v, 1.0 - alpha, none, 1.0 - alpha, none);
  }
  [[nodiscard]] bool posed() const { return singular.isZero(0.0) || system.order < 0.5; }

  [[nodiscard]] std::vector<PowerLoad> loads() const {
    const double alpha = system.order;
    if (singular.isZero(0.0)) return {};
    Vec coefficients = Vec::Zero(states);
    coefficients.segment<n>(n) = singular / std::tgamma(2.0 - 2.0 * alpha);
    return {{1.0 - 2.0 * alpha, coefficients}};
  }

  template <class S>
  Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = y.template head<n>(), v = y.template segment<n>(n), w = y.template tail<n>();
    const double alpha = system.order;
    Vector<S, n> s = y.template segment<n>(2 * n);
    if (!singular.isZero(0.0))
      s += (singular * (std::pow(t, 1.0 - 2.0 * alpha) / std::tgamma(2.0 - 2.0 * alpha))).template cast<S>();
    const auto rates = constraint_rates<S>(system, S(t), q, v, w);
    const Reaction<S, System> reaction(system, q, rates);
    const Vector<S, n> free = free_acceleration<S>(system, S(t), q, v);
    Vector<S, System::constraints> defect = rates.slope * free + rates.flow + rates.memory * s;
    if (kappa != 0.0) defect += S(kappa) * rates.value;
    Vector<S, n> acceleration = free + reaction.answer(defect);
    if (t > 0.0 && !start.v.isZero(0.0)) {
      const Vector<S, System::constraints> started = rates.memory * start.v.template cast<S>();
      acceleration += (reaction.answer(started) - singular.template cast<S>()) *
                      S(std::pow(t, -alpha) / std::tgamma(1.0 - alpha));
    }
    return joined<S>(v, s, acceleration, v);
  }
  [[nodiscard]] Columns<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {y.template head<n>(), y.template segment<n>(n), y.template tail<n>()};
  }
};

// Constraints that are affine in the velocity, f = a(t, q) v + beta(t, q, w) (equation 38):
//   q' = v = P z - a^# beta,  z' = P (free acceleration) + P' v,
// P and a^# as in whole_order.hpp. For constant a and f = a.v + b.w - C0 this is q' = z - A w, z' = -P grad u
// with A = a b^T/|a|^2, and no term is singular.
template <class System>
struct IntegratedBelowOne {
  static constexpr int n = System::coordinates, states = 3 * n;
  System system;
  Motion<n> start;

  [[nodiscard]] std::vector<Component> components() const {
    const Vector<double, n> none = Vector<double, n>::Zero();
    const Vector<double, n> free_part = Projection<double, System>(system, 0.0, start.q, none).of(start.v);
    return rows(1.0, start.q, 1.0, free_part, 1.0 - system.order, none);
  }

  template <class S>
  Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = y.template head<n>(), z = y.template segment<n>(n), w = y.template tail<n>();
    const Projection<S, System> projection(system, S(t), q, w);
    const Vector<S, n> v = projection.velocity(z);
    const Vector<S, n> free = free_acceleration<S>(system, S(t), q, v);
    return joined<S>(v, Vector<S, n>(projection.of(free) + projection_rate<S>(system, S(t), q, v)), v);
  }
  [[nodiscard]] Columns<n> columns(double t, const Vector<double, states>& y) const {
    const Vector<double, n> q = y.template head<n>(), z = y.template segment<n>(n), w = y.template tail<n>();
    return {q, Projection<double, System>(system, t, q, w).velocity(z), w};
  }
};

// q' = v, v' = free acceleration + G^-1 (df/dv)^T lambda, 0 = f. Where lambda is unbounded at 0 it starts
// from 0, which costs nothing but itself: the constraint fixes what it does to v.
template <class System>
struct MultiplierBelowOne {
  static constexpr int n = System::coordinates, r = System::constraints, states = 3 * n + r;
  System system;
  Motion<n> start;

  [[nodiscard]] std::vector<Component> components() const {
    const Vector<double, n> none = Vector<double, n>::Zero();
    Vector<double, r> lambda = Vector<double, r>::Zero();
    if (singular_direction(system, start).isZero(0.0)) {
      const auto rates = constraint_rates<double>(system, 0.0, start.q, start.v, none);
      const Reaction<double, System> reaction(system, start.q, rates);
      lambda = reaction.multiplier(rates.slope * free_acceleration<double>(system, 0.0, start.q, start.v) +
                                   rates.flow);
    }
    return rows(1.0, start.q, 1.0, start.v, 1.0 - system.order, none, 0.0, lambda);
  }

  template <class S>
  Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = y.template head<n>(), v = y.template segment<n>(n),
                       w = y.template segment<n>(2 * n);
    const Vector<S, r> lambda = y.template tail<r>();
    const auto rates = constraint_rates<S>(system, S(t), q, v, w);
    const Vector<S, n> acceleration = free_acceleration<S>(system, S(t), q, v) +
                                      raised<S>(system, q, Vector<S, n>(rates.reaction.transpose() * lambda));
    return joined<S>(v, acceleration, v, rates.value);
  }
  [[nodiscard]] Columns<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {y.template head<n>(), y.template segment<n>(n), y.template segment<n>(2 * n)};
  }
};

}  // namespace fde::mechanics
