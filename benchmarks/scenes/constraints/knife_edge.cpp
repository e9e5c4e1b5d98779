// SPDX-License-Identifier: MIT
#include <numbers>

#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/closed_forms/quotients.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

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

// Chaplygin's skate on a slope: it does not slide down but drifts sideways.
SceneFactory knife_edge() {
  const std::vector<Parameter> parameters{
      {"g", 9.81, any_number, "acceleration of gravity"},
      {"theta", 0.5, {.low = 0.0, .high = std::numbers::pi / 2}, "slope of the plane, radians"},
      {"omega", 1.0, any_number, "phi'(0)"}};
  return {
      .id = "knife_edge",
      .title = "Blade on an inclined plane",
      .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, with x' sin phi = y' cos phi",
      .parameters = with_formulations(parameters, all_formulations()),
      .make = [](const Parameters& p) -> Scene {
        const MechanicalSetup<Blade> setting{.system = {p["g"] * std::sin(p["theta"])},
                                             .start = {Vector<double, 3>::Zero(), {0.0, 0.0, p["omega"]}},
                                             .coordinates = {"x", "y", "phi"}};
        Scene scene = mechanical_scene(setting, formulation_choice_of(p));
        scene.reference = reference::closed_form(KnifeEdgeMotion{p["g"], p["theta"], p["omega"]});
        scene.display_path = select_components({"x", "y"}, {0, 1});
        return scene;
      },
      .equations = {{.unknown = "x",
                     .terms = {{"1", "2"}},
                     .rhs = "g*sin(theta) + lambda*sin(phi)",
                     .initial = {"0", "0"}},
                    {.unknown = "y", .terms = {{"1", "2"}}, .rhs = "-lambda*cos(phi)", .initial = {"0", "0"}},
                    {.unknown = "phi", .terms = {{"1", "2"}}, .rhs = "0", .initial = {"0", "omega"}},
                    {.unknown = "lambda",
                     .terms = {{"1", "0"}},
                     .rhs = "D(x,1)*sin(phi) - D(y,1)*cos(phi)",
                     .initial = {"0"}}}};
}

}  // namespace fde::bench
