#include <cmath>

#include "scenes/equations/sine_field.hpp"

namespace fde {

// Stiff: the eigenvalues reach from pi^2 to 4 (components + 1)^2, times the diffusivity.
SceneMaker fractional_diffusion() {
  std::vector<Parameter> parameters{
      {"gamma", 0.5, order_up_to_two, "order; a wave above 1, which starts at rest"},
      {"diffusivity", 1.0, positive, "kappa in D^gamma u = kappa u_xx"},
      {"components", 200.0, {.low = 2.0, .high = 1e6}, "points inside (0, 1), whole"}};
  for (auto& parameter : start_parameters()) parameters.push_back(std::move(parameter));
  return {.id = "fractional_diffusion",
          .title = "Fractional diffusion, semi-discretised",
          .source = "Lin & Xu, J. Comput. Phys. 225 (2007); second differences in space",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            const SinePoints points = points_of(p, "components");
            return scene_of_field(
                {points, start_of(p, points, "components"), 1, p["gamma"], p["diffusivity"]}, p["gamma"]);
          },
          .shown = {{"D(u, gamma)", "diffusivity*u_xx"}}};
}

}  // namespace fde
