// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "fdebench/benchmarks/scenes/constraints/oscillator_chain.hpp"

namespace fde::bench {

using namespace mechanics;

// With equal frictions of two masses and none of the third e^(-E/T) is a stationary density, T = v1^2 + v2^2:
// the power of friction and reaction together is T times the rate of the phase volume. For other frictions
// that are above 0 and not equal this holds for no T (docs/mechanics.md, Ensembles). With three equal ones
// the motion is that of isokinetic. Not affine in the velocity: there is no integrated form.
SceneFactory canonical_ensemble() {
  const std::vector<Parameter> parameters =
      chain_parameters({{"gamma1", 1.0, not_negative, "friction of the first mass"},
                        {"gamma2", 1.0, not_negative, "friction of the second mass"},
                        {"gamma3", 0.0, not_negative, "friction of the third mass"}});
  return {.id = "canonical_ensemble",
          .title = "Chain of oscillators at a constant temperature",
          .source = "Tarasov & Zaslavsky 2006, eqs 7, 13, section 5 (canonical ensemble)",
          .parameters = with_formulations(parameters, unprojected_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const auto start = chain_start(p);
            const Vector<double, 3> friction(p["gamma1"], p["gamma2"], p["gamma3"]);
            if (friction.cwiseProduct(start.v).isZero(0.0))
              reject("v1", p["v1"], "such that a mass with friction moves");
            const double temperature = friction.dot(start.v.cwiseAbs2()) / friction.sum();
            const MechanicalSetup<CanonicalChain> setting{.system = {{p["k"], p["c"]}, friction, temperature},
                                                          .start = start,
                                                          .coordinates = {"q1", "q2", "q3"},
                                                          .reference = Formulation::acceleration};
            return mechanical_scene(setting, formulation_choice_of(p));
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

}  // namespace fde::bench
