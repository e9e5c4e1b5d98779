#include "mechanics/formulations/mechanical_scene.hpp"
#include "scenes/constraints/classical_systems.hpp"

namespace fde {

using namespace mechanics;

// Tarasov's condition for e^(-E/T) to be a stationary density, the power of the forces without potential
// being T times the rate of the phase volume, is taken of the friction and kept by a reaction. With equal
// frictions the motion is that of isokinetic with the kinetic energy 3 T / 2. Not affine in the velocity:
// there is no integrated form.
SceneMaker canonical_ensemble() {
  static const std::vector<Formulation> fitting{Formulation::acceleration, Formulation::stabilised,
                                                Formulation::multiplier};
  const std::vector<Parameter> parameters{{"k", 1.0, not_negative, "stiffness of the springs"},
                                          {"c", 0.5, not_negative, "stiffness that grows with the square"},
                                          {"gamma1", 0.2, positive, "friction of the first mass"},
                                          {"gamma2", 0.5, positive, "friction of the second mass"},
                                          {"gamma3", 1.0, positive, "friction of the third mass"},
                                          {"q1", 0.5, any_number, "q1(0)"},
                                          {"q2", 0.0, any_number, "q2(0)"},
                                          {"q3", -0.3, any_number, "q3(0)"},
                                          {"v1", 0.6, any_number, "q1'(0); the velocities make T"},
                                          {"v2", -0.4, any_number, "q2'(0)"},
                                          {"v3", 0.3, any_number, "q3'(0)"}};
  return {.id = "canonical_ensemble",
          .title = "Chain of oscillators with friction at a constant temperature",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5 (canonical ensemble)",
          .parameters = with_formulations(parameters, fitting),
          .make = [](const Parameters& p) -> Scene {
            const Vector<double, 3> v(p["v1"], p["v2"], p["v3"]),
                friction(p["gamma1"], p["gamma2"], p["gamma3"]);
            if (v.isZero(0.0)) reject("v1", 0.0, "other than 0 where v2 = 0 and v3 = 0: nothing would move");
            const double temperature = friction.dot(v.cwiseAbs2()) / friction.sum();
            const Setting<CanonicalChain> setting{.system = {{p["k"], p["c"]}, friction, temperature},
                                                  .start = {{p["q1"], p["q2"], p["q3"]}, v},
                                                  .coordinates = {"q1", "q2", "q3"},
                                                  .reference = Formulation::acceleration};
            return mechanical_scene(setting, asked_of(p));
          }};
}

}  // namespace fde
