#include "mechanics/formulations/mechanical_scene.hpp"
#include "scenes/constraints/classical_systems.hpp"

namespace fde {

using namespace mechanics;

// Not affine in the velocity: there is no integrated form.
SceneMaker isokinetic() {
  static const std::vector<Formulation> fitting{Formulation::acceleration, Formulation::stabilised,
                                                Formulation::multiplier};
  const std::vector<Parameter> parameters{{"k", 1.0, not_negative, "stiffness of the springs"},
                                          {"c", 0.5, not_negative, "stiffness that grows with the square"},
                                          {"q1", 0.5, any_number, "q1(0)"},
                                          {"q2", 0.0, any_number, "q2(0)"},
                                          {"q3", -0.3, any_number, "q3(0)"},
                                          {"v1", 0.6, any_number, "q1'(0)"},
                                          {"v2", -0.4, any_number, "q2'(0)"},
                                          {"v3", 0.3, any_number, "q3'(0)"}};
  return {.id = "isokinetic",
          .title = "Chain of oscillators with constant kinetic energy",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5 (Gaussian thermostat)",
          .parameters = with_formulations(parameters, fitting),
          .make = [](const Parameters& p) -> Scene {
            const Vector<double, 3> v(p["v1"], p["v2"], p["v3"]);
            if (v.isZero(0.0)) reject("v1", 0.0, "other than 0 where v2 = 0 and v3 = 0: nothing would move");
            const Setting<ThermostattedChain> setting{.system = {{p["k"], p["c"]}, 0.5 * v.squaredNorm()},
                                                      .start = {{p["q1"], p["q2"], p["q3"]}, v},
                                                      .coordinates = {"q1", "q2", "q3"},
                                                      .reference = Formulation::acceleration};
            return mechanical_scene(setting, asked_of(p));
          }};
}

}  // namespace fde
