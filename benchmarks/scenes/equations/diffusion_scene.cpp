// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/diffusion_scene.hpp"

#include <memory>
#include <utility>

#include "fdebench/benchmarks/scenes/equations/medium.hpp"
#include "fdebench/benchmarks/scenes/equations/sine_field.hpp"
#include "fdebench/benchmarks/scenes/equations/variable_coefficient_field.hpp"

namespace fde::bench {

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

}  // namespace fde::bench
