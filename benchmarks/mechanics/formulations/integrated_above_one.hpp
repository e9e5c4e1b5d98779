// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/mechanics/projection.hpp"

// The integrated formulation for constraints f = a.v + b.w + c with constant a, b, c and w = D^alpha q, 1 <
// alpha < 2: w = D^(alpha-1) v, and D^(2-alpha) w is v' without its part t^(alpha-2)/Gamma(alpha-1) w(0). P
// w(0) = 0. The acceleration form would have the highest derivative D^(1+alpha) q inside the reaction; it is
// not offered.
namespace fde::bench::mechanics {

// The vectors a, b and constants of one constraint a.v + b.w + c = 0.
template <class System>
class ConstantConstraint {
  static constexpr int n = System::coordinates;
  static_assert(System::constraints == 1);

 public:
  ConstantConstraint(const System& system, const Vector<double, n>& q)
      : projection_(system, 0.0, q, zeros<double, n>()),
        direction_(-projection_.reaction().compensating_acceleration(Vector<double, 1>::Ones())),
        acceleration_jacobian_(projection_.rates().acceleration_jacobian.transpose()),
        memory_jacobian_(projection_.rates().memory_jacobian.transpose()),
        constant_(projection_.rates().value[0]),
        alignment_(
            zero_if_rounding(memory_jacobian_.dot(direction_), size_of(memory_jacobian_, direction_))) {}

  [[nodiscard]] Vector<double, n> projected(const Vector<double, n>& x) const {
    return projection_.project(x);
  }
  [[nodiscard]] const Vector<double, n>& direction() const { return direction_; }  // a^#: a.a^# = 1
  [[nodiscard]] const Vector<double, n>& memory_jacobian() const { return memory_jacobian_; }  // b
  [[nodiscard]] double constant() const { return constant_; }                                  // c
  [[nodiscard]] double alignment() const { return alignment_; }                                // b.a^#
  // The w(0) along a^# with f = 0; 0 if C0 = -c equals a.v(0). Requires b.a^# != 0.
  [[nodiscard]] Vector<double, n> initial_memory(const Vector<double, n>& velocity) const {
    const double size = size_of(acceleration_jacobian_, velocity) + std::abs(constant_);
    const double missing = -zero_if_rounding(acceleration_jacobian_.dot(velocity) + constant_, size);
    return direction_ * (missing / alignment_);
  }

 private:
  static double size_of(const Vector<double, n>& x, const Vector<double, n>& y) {
    return x.cwiseAbs().dot(y.cwiseAbs());
  }

  Projection<double, System> projection_;
  Vector<double, n> direction_, acceleration_jacobian_, memory_jacobian_;
  double constant_, alignment_;
};

// With z = P v, chi = b.v and W = P w:
//   q' = v = z + a^# (a.v),  a.v = (chi - b.z) / (b.a^#),
//   z' = P (free acceleration),  D^(2-alpha) W = P (free acceleration),  D^(alpha-1) chi = b.w = -c - a.v.
// Requires b.a^# != 0: otherwise the constraint contains no derivative of order alpha along a^#.
template <class System>
struct IntegratedAboveOne {
  static constexpr int n = System::coordinates;
  static constexpr Layout layout{.q = {0, n}, .z = {n, n}, .chi = {2 * n, 1}, .w = {2 * n + 1, n}};
  static constexpr int states = layout.size();
  System system;
  InitialState<n> start;
  ConstantConstraint<System> constraint{system, start.q};

  [[nodiscard]] std::vector<Component> components() const {
    const Vector<double, 1> chi(constraint.memory_jacobian().dot(start.v));
    return rows(1.0, start.q, 1.0, constraint.projected(start.v), system.order - 1.0, chi, 2.0 - system.order,
                zeros<double, n>());
  }
  [[nodiscard]] bool is_well_posed() const { return constraint.alignment() != 0.0; }

  template <class S>
  [[nodiscard]] Vector<S, states> rhs(double t, const Vector<S, states>& y) const {
    const Vector<S, n> q = part<layout.q>(y), z = part<layout.z>(y);
    const S fixed = (y[layout.chi.first] - converted_to<S, n>(constraint.memory_jacobian()).dot(z)) /
                    S(constraint.alignment());
    const Vector<S, n> v = z + converted_to<S, n>(constraint.direction()) * fixed;
    const Vector<S, n> free = Projection<S, System>(system, S(t), q, zeros<S, n>())
                                  .project(free_acceleration<S>(system, S(t), q, v));
    return stacked<S>(v, free, Vector<S, 1>(S(-constraint.constant()) - fixed), free);
  }
  [[nodiscard]] OutputValues<n> columns(double /*t*/, const Vector<double, states>& y) const {
    const Vector<double, n> z = part<layout.z>(y), free_memory = part<layout.w>(y);
    const auto &b = constraint.memory_jacobian(), &direction = constraint.direction();
    const double fixed = (y[layout.chi.first] - b.dot(z)) / constraint.alignment();
    const double memory = (-constraint.constant() - fixed - b.dot(free_memory)) / constraint.alignment();
    return {part<layout.q>(y), z + direction * fixed, free_memory + direction * memory};
  }
};

}  // namespace fde::bench::mechanics
