#include "mechanics/formulations/conditional_extremum.hpp"
#include "scenes/constraints/particle.hpp"

namespace fde {

// The conditional extremum under z' = y x'. With mu(0) = 0 it starts along the motion of
// nonholonomic_particle and leaves it, unless x'(0) = 0 or y'(0) = 0.
SceneMaker vakonomic_particle() {
  auto parameters = particle_parameters();
  parameters.push_back({"mu0", 0.0, any_number, "multiplier at t = 0"});
  return {.id = "vakonomic_particle",
          .title = "Conditional extremum of a free particle under z' = y x'",
          .source = "Tarasov & Zaslavsky 2006, eq. 67",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            return mechanics::extremum_scene(particle_setting(p), mechanics::Vector<double, 1>(p["mu0"]));
          }};
}

}  // namespace fde
