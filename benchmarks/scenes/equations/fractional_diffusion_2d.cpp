#include <cmath>

#include "scenes/equations/sine_field.hpp"

namespace fde {

// Stiff: the eigenvalues reach from 2 pi^2 to 8 (n + 1)^2, times the diffusivity.
SceneMaker fractional_diffusion_2d() {
  std::vector<Parameter> parameters{
      {"gamma", 0.5, order_up_to_two, "order; a wave above 1, which starts at rest"},
      {"diffusivity", 1.0, positive, "kappa in D^gamma u = kappa (u_xx + u_yy)"},
      {"n", 8.0, {.low = 2.0, .high = 1000.0}, "n x n points inside the unit square, whole"}};
  for (auto& parameter : start_parameters()) parameters.push_back(std::move(parameter));
  return {.id = "fractional_diffusion_2d",
          .title = "Fractional diffusion in a square, semi-discretised",
          .source = "Zhang & Sun, J. Comput. Phys. 230 (2011); the five-point Laplacian in space",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            const SinePoints points = points_of(p, "n");
            return scene_of_field({points, start_of(p, points, "n"), 2, p["gamma"], p["diffusivity"]},
                                  p["gamma"]);
          },
          .shown = {{"D(u, gamma)", "diffusivity*(u_xx + u_yy)"}}};
}

}  // namespace fde
