// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "fdebench/benchmarks/scenes/equations/sine_field.hpp"
#include "fdebench/benchmarks/scenes/equations/variable_coefficient_field.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

namespace {

// The parameters and the scene shared by the diffusion scenes in one and two dimensions. `points` is the
// parameter, named `points_name`, that gives the number of points of an axis.
std::vector<Parameter> diffusion_parameters(Parameter points, const char* diffusivity) {
  std::vector<Parameter> all{{"gamma", 0.5, order_up_to_two, "order; a wave above 1, which starts at rest"},
                             {"diffusivity", 1.0, positive, diffusivity},
                             std::move(points)};
  for (auto& parameter : start_parameters()) all.push_back(std::move(parameter));
  for (auto& parameter : medium_parameters()) all.push_back(std::move(parameter));
  return all;
}

Scene diffusion_scene(const Parameters& parameters, const char* points_name, int dimensions) {
  const SineGrid points = points_of(parameters, points_name);
  InitialField start = initial_field(parameters, points, points_name);
  const double order = parameters["gamma"], diffusivity = parameters["diffusivity"];
  const Medium medium(parameters);
  std::shared_ptr<const LinearField> field;
  if (medium.is_uniform()) {
    field = std::make_shared<const SineField>(points, std::move(start), dimensions, order, diffusivity);
  } else {
    field = std::make_shared<const VariableCoefficientField>(points, std::move(start), dimensions, order,
                                                             diffusivity, medium);
  }
  return scene_of_field(field, order);
}

}  // namespace

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
