// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/diffusion_scene.hpp"

namespace fde::bench {

// Stiff: the eigenvalues range from pi^2 to 4 (components + 1)^2, times the diffusivity.
SceneFactory fractional_diffusion() {
  return {.id = "fractional_diffusion",
          .title = "Fractional diffusion, semi-discretised",
          .source = "Lin & Xu, J. Comput. Phys. 225 (2007); second differences in space",
          .parameters = diffusion_parameters(
              {"components", 200.0, {.low = 2.0, .high = 1e6}, "points inside (0, 1), whole"},
              "kappa in D^gamma u = kappa (a u_x)_x"),
          .make = [](const Parameters& p) { return diffusion_scene(p, "components", 1); },
          .display_equations = {{"D(u, gamma)", "kappa*div(a*grad(u))"}}};
}

}  // namespace fde::bench
