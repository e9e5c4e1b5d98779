#include "scene.hpp"

#include <algorithm>

#include "collocation.hpp"
#include "reference_cache.hpp"

namespace fde {

#define FDE_SCENE(id) SceneMaker id();
#include "scenes/list.def"
#undef FDE_SCENE

std::span<const SceneMaker> scenes() {
  static const std::vector<SceneMaker> all{
#define FDE_SCENE(id) id(),
#include "scenes/list.def"
#undef FDE_SCENE
  };
  return all;
}

const SceneMaker* scene_of_label(std::string_view label) {
  const auto found = std::ranges::find(scenes(), label.substr(0, label.find(':')), &SceneMaker::id);
  return found == scenes().end() ? nullptr : &*found;
}

Rows shown(const Scene& scene, const Rows& components) {
  if (scene.outputs.components.empty()) return components;
  return components(scene.outputs.components, Eigen::all);
}

Exact truth_of(const Scene& scene) {
  if (scene.exact.at) return scene.exact;
  if (scene.name.empty()) return reference_solution(scene.problem);
  return cached_reference(scene.name, scene.problem, ReferenceCache(cache_folder()));
}

}  // namespace fde
