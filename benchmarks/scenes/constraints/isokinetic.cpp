// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "fdebench/benchmarks/scenes/constraints/oscillator_chain.hpp"

namespace fde::bench {

using namespace mechanics;

// The constraint is not affine in the velocity, so there is no integrated formulation.
SceneFactory isokinetic() {
  return {.id = "isokinetic",
          .title = "Chain of oscillators with constant kinetic energy",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5 (Gaussian thermostat)",
          .parameters = with_formulations(chain_parameters(), unprojected_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const auto start = chain_start(p);
            const MechanicalSetup<ThermostattedChain> setting{
                .system = {{p["k"], p["c"]}, 0.5 * start.v.squaredNorm()},
                .start = start,
                .coordinates = {"q1", "q2", "q3"},
                .reference = Formulation::acceleration};
            return mechanical_scene(setting, formulation_choice_of(p));
          },
          .equations = {{.unknown = "q1",
                         .terms = {{"1", "2"}},
                         .rhs = "-k*q1 - c*q1^3 + k*(q2 - q1) + c*(q2 - q1)^3 + lambda*D(q1,1)",
                         .initial = {"q1", "v1"}},
                        {.unknown = "q2",
                         .terms = {{"1", "2"}},
                         .rhs = "-k*(q2 - q1) - c*(q2 - q1)^3 + k*(q3 - q2) + c*(q3 - q2)^3 + lambda*D(q2,1)",
                         .initial = {"q2", "v2"}},
                        {.unknown = "q3",
                         .terms = {{"1", "2"}},
                         .rhs = "-k*(q3 - q2) - c*(q3 - q2)^3 - k*q3 - c*q3^3 + lambda*D(q3,1)",
                         .initial = {"q3", "v3"}},
                        {.unknown = "lambda",
                         .terms = {{"1", "0"}},
                         .rhs = "(D(q1,1)^2 + D(q2,1)^2 + D(q3,1)^2 - v1^2 - v2^2 - v3^2)/2",
                         .initial = {"0"}}}};
}

}  // namespace fde::bench
