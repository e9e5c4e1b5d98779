// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <numbers>

#include "fdebench/benchmarks/mechanics/system.hpp"

// Mechanical systems of the scenes with constraints of integer order, f(t, q, v) = 0.
namespace fde::bench::mechanics {

// A free particle of mass 1 constrained to the planes dz = y dx: f = z' - y x'.
struct Particle {
  static constexpr int coordinates = 3, constraints = 1;

  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 3>& q, const Vector<S, 3>& v) const {
    return Vector<S, 1>(S(v[2] - q[1] * v[0]));
  }
};

// A blade (knife edge) with mass and moment of inertia 1; pull = g sin theta along x.
struct Blade {
  static constexpr int coordinates = 3, constraints = 1;
  double pull;

  template <class S>
  [[nodiscard]] S potential(const Vector<S, 3>& q) const {
    return -pull * q[0];
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 3>& q, const Vector<S, 3>& v) const {
    using std::cos, std::sin;
    return Vector<S, 1>(S(v[0] * sin(q[2]) - v[1] * cos(q[2])));
  }
};

// A vertical disc: contact point x, y, heading phi, rolling angle psi; pull: a uniform acceleration along x.
struct Disc {
  static constexpr int coordinates = 4, constraints = 2;
  double radius, mass, spin_inertia, turn_inertia, pull;

  template <class S>
  [[nodiscard]] Diagonal<S, 4> metric(const Vector<S, 4>& /*q*/) const {
    return Diagonal<S, 4>({S(mass), S(mass), S(turn_inertia), S(spin_inertia)});
  }
  template <class S>
  [[nodiscard]] S potential(const Vector<S, 4>& q) const {
    return -mass * pull * q[0];
  }
  template <class S>
  [[nodiscard]] Vector<S, 2> constraint(const S& /*t*/, const Vector<S, 4>& q, const Vector<S, 4>& v) const {
    using std::cos, std::sin;
    return {v[0] - radius * v[3] * cos(q[2]), v[1] - radius * v[3] * sin(q[2])};
  }
};

// A point of mass 1 on the unit sphere with a constant course: phi' sin theta = k theta'. theta is the
// distance from the pole. The coordinates are singular at the poles: NaN outside (0, pi), which ends a run.
struct ConstantCourseOnSphere {
  static constexpr int coordinates = 2, constraints = 1;
  double k;

  template <class S>
  [[nodiscard]] static S sine(const S& theta) {
    using std::sin;
    return theta > 0.0 && theta < std::numbers::pi ? S(sin(theta))
                                                   : S(std::numeric_limits<double>::quiet_NaN());
  }
  template <class S>
  [[nodiscard]] Diagonal<S, 2> metric(const Vector<S, 2>& q) const {
    const S s = sine<S>(q[0]);
    return Diagonal<S, 2>({S(1.0), s * s});
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 2>& q, const Vector<S, 2>& v) const {
    return Vector<S, 1>(S(v[1] * sine<S>(q[0]) - k * v[0]));
  }
};

// Three unit masses in a row between walls, with springs of potential k s^2/2 + c s^4/4 between neighbours.
struct SpringChain {
  static constexpr int coordinates = 3;
  double k, c;

  template <class S>
  [[nodiscard]] S spring(const S& length) const {
    const S square = length * length;
    return 0.5 * k * square + 0.25 * c * square * square;
  }
  template <class S>
  [[nodiscard]] S potential(const Vector<S, 3>& q) const {
    S sum = spring<S>(q[0]) + spring<S>(q[2]);
    for (int i = 0; i < 2; ++i) sum += spring<S>(q[i + 1] - q[i]);
    return sum;
  }
};

// A Gaussian thermostat keeps the kinetic energy constant: f = 1/2 |v|^2 - K.
struct ThermostattedChain : SpringChain {
  static constexpr int constraints = 1;
  double kinetic;

  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 3>& /*q*/,
                                        const Vector<S, 3>& v) const {
    return Vector<S, 1>(S(0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - kinetic));
  }
};

// With friction F_i = -gamma_i v_i. Its power P = -sum gamma_i v_i^2 must equal the temperature T times the
// rate of change of phase volume Omega = sum dF_i/dv_i: f = (T Omega - P)/2. The reaction is parallel to the
// friction and cancels it.
struct CanonicalChain : SpringChain {
  static constexpr int constraints = 1;
  Vector<double, 3> friction;
  double temperature;

  template <class S>
  [[nodiscard]] Vector<S, 3> force(const S& /*t*/, const Vector<S, 3>& /*q*/, const Vector<S, 3>& v) const {
    return {-friction[0] * v[0], -friction[1] * v[1], -friction[2] * v[2]};
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& t, const Vector<S, 3>& q, const Vector<S, 3>& v) const {
    const S power = v.dot(force<S>(t, q, v));
    return Vector<S, 1>(S(0.5 * (-temperature * friction.sum() - power)));
  }
};

// Without the last wall: the third mass is a piston, on which a pressure acts. A thermostat keeps the kinetic
// energy of the other two: f = (v1^2 + v2^2 - T)/2.
struct PistonChain : SpringChain {
  static constexpr int constraints = 1;
  double pressure, temperature;

  template <class S>
  [[nodiscard]] S potential(const Vector<S, 3>& q) const {
    return spring<S>(q[0]) + spring<S>(q[1] - q[0]) + spring<S>(q[2] - q[1]) + pressure * q[2];
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 3>& /*q*/,
                                        const Vector<S, 3>& v) const {
    return Vector<S, 1>(S(0.5 * (v[0] * v[0] + v[1] * v[1] - temperature)));
  }
};

}  // namespace fde::bench::mechanics
