#pragma once

#include "mechanics/formulations/mechanical_scene.hpp"
#include "scenes/constraints/classical_systems.hpp"

namespace fde {

// The parameters of a Particle, y0, dx0, dy0, the motion they start, x(0) = z(0) = 0 and z'(0) = y0 dx0, and
// the setting.
std::vector<Parameter> particle_parameters();
mechanics::Setting<mechanics::Particle> particle_setting(const Parameters& p);

}  // namespace fde
