#pragma once

#include "scenes/scene.hpp"

namespace fde {

// What the scenes of diffusion share: all parameters, of points an axis counted by this one, and the scene.
std::vector<Parameter> diffusion_parameters(Parameter points, const char* diffusivity);
Scene diffusion_scene(const Parameters& parameters, const char* points_name, int dimensions);

}  // namespace fde
