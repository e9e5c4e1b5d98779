// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"

namespace fde::bench {

// The parameters y0, dx0, dy0 of a Particle, and its setting with x(0) = z(0) = 0 and z'(0) = y0 dx0.
std::vector<Parameter> particle_parameters();
mechanics::MechanicalSetup<mechanics::Particle> particle_setting(const Parameters& p);

}  // namespace fde::bench
