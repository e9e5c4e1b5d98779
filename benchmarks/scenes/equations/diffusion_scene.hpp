// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The parameters and the scene shared by the diffusion scenes in one and two dimensions. `points` is the
// parameter, named `points_name`, that gives the number of points of an axis.
std::vector<Parameter> diffusion_parameters(Parameter points, const char* diffusivity);
Scene diffusion_scene(const Parameters& parameters, const char* points_name, int dimensions);

}  // namespace fde::bench
