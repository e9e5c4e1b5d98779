#include "mechanics/formulations/mechanical_scene.hpp"
#include "scenes/constraints/classical_systems.hpp"
#include "scenes/constraints/oscillator_chain.hpp"

namespace fde {

using namespace mechanics;

// Not affine in the velocity: there is no integrated form.
SceneMaker isokinetic() {
  return {.id = "isokinetic",
          .title = "Chain of oscillators with constant kinetic energy",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5 (Gaussian thermostat)",
          .parameters = with_formulations(chain_parameters(), unprojected_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const auto start = chain_start(p);
            const Setting<ThermostattedChain> setting{
                .system = {{p["k"], p["c"]}, 0.5 * start.v.squaredNorm()},
                .start = start,
                .coordinates = {"q1", "q2", "q3"},
                .reference = Formulation::acceleration};
            return mechanical_scene(setting, asked_of(p));
          }};
}

}  // namespace fde
