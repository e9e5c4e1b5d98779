// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/with_reference.hpp"

#include <utility>

namespace fde::bench {
namespace {

ParameterValues values_of(const SceneFactory& scene, const Parameters& all) {
  ParameterValues values;
  for (const auto& parameter : scene.parameters) {
    if (parameter.default_formula.empty() || all.explicit_value(parameter.name))
      values[parameter.name] = all.value(parameter.name);
  }
  return values;
}

}  // namespace

SceneFactory with_reference(SceneFactory file,
                            const std::function<reference::Reference(const Parameters&)>& reference) {
  file.make = [make = std::move(file.make), reference](const Parameters& p) {
    Scene scene = make(p);
    scene.reference = reference(p);
    return scene;
  };
  return file;
}

Parameters parameters_of(const SceneFactory& scene, const Parameters& all) {
  return {scene.id, scene.parameters, values_of(scene, all)};
}

Parameters with_value(const SceneFactory& scene, const Parameters& all, const std::string& name,
                      double value) {
  auto values = values_of(scene, all);
  values[name] = value;
  return {scene.id, scene.parameters, values};
}

}  // namespace fde::bench
