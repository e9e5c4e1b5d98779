// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/with_reference.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde::bench {
namespace {

// phi = omega t; the speed along the blade is (a/omega) sin phi, with a = g sin theta. Hence
//   x = (a / 2 omega^2) sin^2 phi,   y = (a / 2 omega^2)(phi - 1/2 sin 2 phi),
// in a form that is regular as omega -> 0, the fall along x.
struct KnifeEdgeMotion {
  double g, theta, omega;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs, std::min, std::sin;
    const Real turning = reference::from_shortest_decimal<Real>(omega), phi = turning * t,
               slope = reference::from_shortest_decimal<Real>(theta);
    const Real a = reference::from_shortest_decimal<Real>(g) * sin(slope);
    const Real half = reference::sine_quotient(phi), full = reference::sine_quotient(Real(2 * phi));
    const Real speed = 4 * abs(a) * t, place = speed * min(t, Real(1 / abs(turning)));
    return {{Real(a * t * t / 2 * half * half), place},
            {Real(a * t * t * reference::sine_defect(Real(2 * phi))), place},
            {phi, abs(phi)},
            {Real(a * t * full), speed},
            {Real(a * t * half * sin(phi)), speed},
            {turning, abs(turning)}};
  }
};

}  // namespace

SceneFactory knife_edge_file();  // of knife_edge.toml

SceneFactory knife_edge() {
  return with_reference(knife_edge_file(), [](const Parameters& p) {
    return reference::closed_form(KnifeEdgeMotion{p["g"], p["theta"], p["omega"]});
  });
}

}  // namespace fde::bench
