#include "mechanics/formulations/mechanical_scene.hpp"
#include "scenes/constraints/classical_systems.hpp"
#include "scenes/constraints/oscillator_chain.hpp"

namespace fde {

using namespace mechanics;

// Tarasov's condition for e^(-E/T) to be a stationary density, the power of the forces without potential
// being T times the rate of the phase volume, is taken of the friction and kept by a reaction. With equal
// frictions the motion is that of isokinetic with the kinetic energy 3 T / 2. Not affine in the velocity:
// there is no integrated form.
SceneMaker canonical_ensemble() {
  const std::vector<Parameter> parameters =
      chain_parameters({{"gamma1", 0.2, positive, "friction of the first mass"},
                        {"gamma2", 0.5, positive, "friction of the second mass"},
                        {"gamma3", 1.0, positive, "friction of the third mass"}});
  return {.id = "canonical_ensemble",
          .title = "Chain of oscillators with friction at a constant temperature",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5 (canonical ensemble)",
          .parameters = with_formulations(parameters, unprojected_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const auto start = chain_start(p);
            const Vector<double, 3> friction(p["gamma1"], p["gamma2"], p["gamma3"]);
            const double temperature = friction.dot(start.v.cwiseAbs2()) / friction.sum();
            const Setting<CanonicalChain> setting{.system = {{p["k"], p["c"]}, friction, temperature},
                                                  .start = start,
                                                  .coordinates = {"q1", "q2", "q3"},
                                                  .reference = Formulation::acceleration};
            return mechanical_scene(setting, asked_of(p));
          },
          .equations = {
              {.unknown = "q1",
               .terms = {{"1", "2"}},
               .rhs = "-k*q1 - c*q1^3 + k*(q2 - q1) + c*(q2 - q1)^3 - gamma1*D(q1,1) + lambda*gamma1*D(q1,1)",
               .initial = {"q1", "v1"}},
              {.unknown = "q2",
               .terms = {{"1", "2"}},
               .rhs = "-k*(q2 - q1) - c*(q2 - q1)^3 + k*(q3 - q2) + c*(q3 - q2)^3 - gamma2*D(q2,1) + "
                      "lambda*gamma2*D(q2,1)",
               .initial = {"q2", "v2"}},
              {.unknown = "q3",
               .terms = {{"1", "2"}},
               .rhs = "-k*(q3 - q2) - c*(q3 - q2)^3 - k*q3 - c*q3^3 - gamma3*D(q3,1) + lambda*gamma3*D(q3,1)",
               .initial = {"q3", "v3"}},
              {.unknown = "lambda",
               .terms = {{"1", "0"}},
               .rhs = "(gamma1*(D(q1,1)^2 - v1^2) + gamma2*(D(q2,1)^2 - v2^2) + gamma3*(D(q3,1)^2 - v3^2))/2",
               .initial = {"0"}}}};
}

}  // namespace fde
