#include "scene.hpp"

#include "collocation.hpp"

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

Rows shown(const Scene& scene, const Rows& components) {
  if (scene.outputs.components.empty()) return components;
  return components(scene.outputs.components, Eigen::all);
}

Exact truth_of(const Scene& scene) {
  return scene.exact.at ? scene.exact : reference_solution(scene.problem);
}

}  // namespace fde
