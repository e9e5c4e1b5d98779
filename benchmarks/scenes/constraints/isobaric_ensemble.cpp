// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "fdebench/benchmarks/scenes/constraints/oscillator_chain.hpp"

namespace fde::bench {

using namespace mechanics;

// The isothermal-isobaric density of the first two masses and of the length q3 is stationary:
// e^(-(u + pressure q3)/T) with T = v1^2 + v2^2 and u the energy of the springs (docs/mechanics.md,
// Ensembles). The springs' lengths q1, q2 - q1 and q3 - q2 are independent then. Not affine in the velocity:
// there is no integrated form.
SceneFactory isobaric_ensemble() {
  const std::vector<Parameter> parameters =
      chain_parameters({{"pressure", 0.5, any_number, "force on the piston, the third mass"}});
  return {.id = "isobaric_ensemble",
          .title = "Chain of oscillators under a piston at a constant temperature",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5; piston of Andersen 1980",
          .parameters = with_formulations(parameters, unprojected_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const auto start = chain_start(p);
            const double temperature = start.v.head<2>().squaredNorm();
            if (temperature == 0.0) reject("v1", p["v1"], "other than 0 where v2 = 0");
            const MechanicalSetup<PistonChain> setting{
                .system = {{p["k"], p["c"]}, p["pressure"], temperature},
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
                         .rhs = "-k*(q3 - q2) - c*(q3 - q2)^3 - pressure",
                         .initial = {"q3", "v3"}},
                        {.unknown = "lambda",
                         .terms = {{"1", "0"}},
                         .rhs = "(D(q1,1)^2 + D(q2,1)^2 - v1^2 - v2^2)/2",
                         .initial = {"0"}}}};
}

}  // namespace fde::bench
