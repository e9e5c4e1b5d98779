// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/closed_forms/quotients.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

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

// Without pull the disc rolls in circles of radius R psi'(0) / phi'(0), for any mass and inertia.
SceneFactory rolling_disc() {
  const std::vector<Parameter> parameters{{"R", 0.5, positive, "radius"},
                                          {"m", 1.0, positive, "mass"},
                                          {"I", 0.125, positive, "moment of inertia about the axle"},
                                          {"J", 0.0625, positive, "moment of inertia about a diameter"},
                                          {"pull", 0.0, any_number, "acceleration along x"},
                                          {"dphi0", 1.0, any_number, "phi'(0)"},
                                          {"dpsi0", 2.0, any_number, "psi'(0)"}};
  return {.id = "rolling_disc",
          .title = "Vertical disc that rolls without sliding",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, with x' = R psi' cos phi, y' = R psi' sin phi",
          .parameters = with_formulations(parameters, all_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const MechanicalSetup<Disc> setting{
                .system = {p["R"], p["m"], p["I"], p["J"], p["pull"]},
                .start = {Vector<double, 4>::Zero(), {p["R"] * p["dpsi0"], 0.0, p["dphi0"], p["dpsi0"]}},
                .coordinates = {"x", "y", "phi", "psi"}};
            Scene scene = mechanical_scene(setting, formulation_choice_of(p));
            scene.reference = reference::closed_form(
                RollingDiscMotion{p["R"], p["m"], p["I"], p["pull"], p["dphi0"], p["dpsi0"]});
            scene.display_path = select_components({"x", "y"}, {0, 1});
            return scene;
          },
          .equations = {
              {.unknown = "x", .terms = {{"m", "2"}}, .rhs = "m*pull + lambda1", .initial = {"0", "R*dpsi0"}},
              {.unknown = "y", .terms = {{"m", "2"}}, .rhs = "lambda2", .initial = {"0", "0"}},
              {.unknown = "phi", .terms = {{"J", "2"}}, .rhs = "0", .initial = {"0", "dphi0"}},
              {.unknown = "psi",
               .terms = {{"I", "2"}},
               .rhs = "-R*(lambda1*cos(phi) + lambda2*sin(phi))",
               .initial = {"0", "dpsi0"}},
              {.unknown = "lambda1",
               .terms = {{"1", "0"}},
               .rhs = "D(x,1) - R*D(psi,1)*cos(phi)",
               .initial = {"0"}},
              {.unknown = "lambda2",
               .terms = {{"1", "0"}},
               .rhs = "D(y,1) - R*D(psi,1)*sin(phi)",
               .initial = {"0"}}}};
}

}  // namespace fde::bench
