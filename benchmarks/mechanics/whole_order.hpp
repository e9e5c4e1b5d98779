#pragma once

#include "motion.hpp"
#include "projection.hpp"

// The formulations of constraints without memory: f(t, q, v) = 0, or f(t, q, v, w) = 0 at order 1, where
// w = v. Then the reaction is along df/dv alone, not along df/dw.
namespace fde::mechanics {

// q' = v, v' = free acceleration + reaction to df/dt + kappa f = 0; kappa = 0: the form as printed.
template <class System>
struct WholeAcceleration {
  static constexpr int n = System::coordinates, states = 2 * n;
  System system;
  Motion<n> start;
  double kappa;

  [[nodiscard]] std::vector<Component> components() const { return rows(1.0, start.q, 1.0, start.v); }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = y.template head<n>(), v = y.template tail<n>();
    const auto rates = constraint_rates<S>(system, S(t), q, v, v);
    const Reaction<S, System> reaction(system, q, rates);
    const Vector<S, n> free = free_acceleration<S>(system, S(t), q, v);
    Vector<S, System::constraints> defect = rates.slope * free + rates.flow;
    if (kappa != 0.0) defect += S(kappa) * rates.value;
    return joined<S>(v, Vector<S, n>(free + reaction.answer(defect)));
  }
  [[nodiscard]] Columns<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {y.template head<n>(), y.template tail<n>(), y.template tail<n>()};
  }
};

// Constraints that are affine in the velocity, f = a(t, q) v + beta(t, q):
//   q' = v = P z - a^# beta,  z' = P (free acceleration) + P' v,
// with the projector P = I - a^# a, a^# = G^-1 reaction^T (a G^-1 reaction^T)^-1. z starts as P v.
template <class System>
struct WholeIntegrated {
  static constexpr int n = System::coordinates, states = 2 * n;
  System system;
  Motion<n> start;

  [[nodiscard]] std::vector<Component> components() const {
    return rows(1.0, start.q, 1.0,
                Projection<double, System>(system, 0.0, start.q, Vector<double, n>::Zero()).of(start.v));
  }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = y.template head<n>(), z = y.template tail<n>();
    const Projection<S, System> projection(system, S(t), q, Vector<S, n>(Vector<S, n>::Constant(S(0.0))));
    const Vector<S, n> v = projection.velocity(z);
    const Vector<S, n> free = free_acceleration<S>(system, S(t), q, v);
    return joined<S>(v, Vector<S, n>(projection.of(free) + projection_rate<S>(system, S(t), q, v)));
  }
  [[nodiscard]] Columns<n> columns(double t, const Vector<double, states>& y) const {
    const Vector<double, n> q = y.template head<n>();
    const Vector<double, n> v =
        Projection<double, System>(system, t, q, Vector<double, n>::Zero()).velocity(y.template tail<n>());
    return {q, v, v};
  }
};

// q' = v, v' = free acceleration + G^-1 (df/dv)^T lambda, 0 = f.
template <class System>
struct WholeMultiplier {
  static constexpr int n = System::coordinates, r = System::constraints, states = 2 * n + r;
  System system;
  Motion<n> start;

  [[nodiscard]] std::vector<Component> components() const {
    const auto rates = constraint_rates<double>(system, 0.0, start.q, start.v, start.v);
    const Reaction<double, System> reaction(system, start.q, rates);
    const Vector<double, n> free = free_acceleration<double>(system, 0.0, start.q, start.v);
    const Vector<double, r> lambda = reaction.multiplier(rates.slope * free + rates.flow);
    return rows(1.0, start.q, 1.0, start.v, 0.0, lambda);
  }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = y.template head<n>(), v = y.template segment<n>(n);
    const auto rates = constraint_rates<S>(system, S(t), q, v, v);
    const Vector<S, r> lambda = y.template tail<r>();
    const Vector<S, n> acceleration = free_acceleration<S>(system, S(t), q, v) +
                                      raised<S>(system, q, Vector<S, n>(rates.reaction.transpose() * lambda));
    return joined<S>(v, acceleration, rates.value);
  }
  [[nodiscard]] Columns<n> columns(double /*t*/, const Vector<double, states>& y) const {
    return {y.template head<n>(), y.template segment<n>(n), y.template segment<n>(n)};
  }
};

}  // namespace fde::mechanics
