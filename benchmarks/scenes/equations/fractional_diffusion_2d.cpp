// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/diffusion_scene.hpp"

namespace fde::bench {

// Stiff: the eigenvalues range from 2 pi^2 to 8 (n + 1)^2, times the diffusivity.
SceneFactory fractional_diffusion_2d() {
  return {.id = "fractional_diffusion_2d",
          .title = "Fractional diffusion in a square, semi-discretised",
          .source = "Zhang & Sun, J. Comput. Phys. 230 (2011); the five-point Laplacian in space",
          .parameters = diffusion_parameters(
              {"n", 8.0, {.low = 2.0, .high = 1000.0}, "n x n points inside the unit square, whole"},
              "kappa in D^gamma u = kappa div(a grad u)"),
          .make = [](const Parameters& p) { return diffusion_scene(p, "n", 2); },
          .display_equations = {{"D(u, gamma)", "kappa*div(a*grad(u))"}}};
}

}  // namespace fde::bench
