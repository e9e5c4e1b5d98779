// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/conditional_extremum.hpp"
#include "fdebench/benchmarks/scenes/constraints/particle.hpp"

namespace fde::bench {

// The conditional extremum under z' = y x'. With mu(0) = 0 it starts like the motion of nonholonomic_particle
// and departs from it, unless x'(0) = 0 or y'(0) = 0.
SceneFactory vakonomic_particle() {
  auto parameters = particle_parameters();
  parameters.push_back({"mu0", 0.0, any_number, "multiplier at t = 0"});
  return {
      .id = "vakonomic_particle",
      .title = "Conditional extremum of a free particle under z' = y x'",
      .source = "Tarasov & Zaslavsky 2006, eq. 67",
      .parameters = parameters,
      .make = [](const Parameters& p) -> Scene {
        return mechanics::extremum_scene(particle_setting(p), mechanics::Vector<double, 1>(p["mu0"]));
      },
      .equations = {{.unknown = "x", .terms = {{"1", "1"}}, .rhs = "dx0 - mu0*y0 + mu*y", .initial = {"0"}},
                    {.unknown = "y",
                     .terms = {{"1", "2"}},
                     .rhs = "-mu*(dx0 - mu0*y0 + mu*y)",
                     .initial = {"y0", "dy0"}},
                    {.unknown = "z", .terms = {{"1", "1"}}, .rhs = "y0*dx0 + mu0 - mu", .initial = {"0"}},
                    {.unknown = "mu",
                     .terms = {{"1", "0"}},
                     .rhs = "y0*dx0 + mu0 - mu - y*(dx0 - mu0*y0 + mu*y)",
                     .initial = {"mu0"}}}};
}

}  // namespace fde::bench
