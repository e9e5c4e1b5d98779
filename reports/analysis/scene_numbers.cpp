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

SceneSettings without(SceneSettings scene, const std::string& parameter) {
  scene.values.erase(parameter);
  if (parameter == end_name) scene.until.reset();
  return scene;
}

std::set<SceneSettings> scenes_of(const Runs& runs) {
  std::set<SceneSettings> scenes;
  for (const auto* some : {&runs.finished, &runs.failed})
    for (const Record& run : *some) scenes.insert(run.key.scene);
  return scenes;
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
