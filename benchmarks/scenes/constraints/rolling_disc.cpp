// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/with_reference.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde::bench {
namespace {

// phi = omega t, and R psi'' = a cos phi with a = pull / (1 + I / (m R^2)). The speed along the heading is R
// psi' = s + a sin(phi)/omega: the path is a circle plus the path of a blade on a slope.
struct RollingDiscMotion {
  double radius, mass, spin_inertia, pull, turn, spin;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs, std::cos, std::min, std::sin;
    const Real r = reference::from_shortest_decimal<Real>(radius),
               m = reference::from_shortest_decimal<Real>(mass),
               inertia = reference::from_shortest_decimal<Real>(spin_inertia);
    const Real a = reference::from_shortest_decimal<Real>(pull) / (1 + inertia / (m * r * r));
    const Real omega = reference::from_shortest_decimal<Real>(turn), phi = omega * t,
               s = r * reference::from_shortest_decimal<Real>(spin);
    const Real half = reference::sine_quotient(Real(phi / 2)), full = reference::sine_quotient(phi),
               twice = reference::sine_quotient(Real(2 * phi));
    const Real x = s * t * full + a * t * t / 2 * full * full;
    const Real y = s * t * half * sin(Real(phi / 2)) + a * t * t * reference::sine_defect(Real(2 * phi));
    const Real rolled = s * t + a * t * t / 2 * half * half;
    const Real speed = 2 * abs(s) + 8 * abs(a) * t, turned = abs(s * phi);
    const Real place = (2 * abs(s) + 8 * abs(a) * min(t, Real(1 / abs(omega)))) * t;
    return {{x, place},
            {y, place},
            {phi, abs(phi)},
            {Real(rolled / r), Real(place / r)},
            {Real(s * cos(phi) + a * t * twice), Real(speed + turned)},
            {Real(s * sin(phi) + a * t * full * sin(phi)), Real(speed + turned)},
            {omega, abs(omega)},
            {Real((s + a * t * full) / r), Real(speed / r)}};
  }
};

}  // namespace

SceneFactory rolling_disc_file();  // of rolling_disc.toml

SceneFactory rolling_disc() {
  return with_reference(rolling_disc_file(), [](const Parameters& p) {
    return reference::closed_form(
        RollingDiscMotion{p["R"], p["m"], p["I"], p["pull"], p["dphi0"], p["dpsi0"]});
  });
}

}  // namespace fde::bench
