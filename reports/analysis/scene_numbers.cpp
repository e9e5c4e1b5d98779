// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/scene_numbers.hpp"

#include <variant>

namespace fde::bench {

SceneSettings with_defaults(const Runs& runs, SceneSettings scene) {
  if (const auto* described = runs.describe(scene)) {
    for (const auto& parameter : described->parameters)
      scene.values.try_emplace(parameter.name, parse_value(parameter.value));
  }
  return scene;
}

std::map<std::string, double> numbers_of(const SceneSettings& scene) {
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : scene.values) {
    if (const auto* number = std::get_if<double>(&value)) numbers.emplace(name, *number);
  }
  if (scene.until) numbers.emplace(end_name, *scene.until);
  return numbers;
}

}  // namespace fde::bench
