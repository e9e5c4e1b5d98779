#include "scenes/registry.hpp"

#include <algorithm>

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

const SceneMaker* find_scene(std::string_view id) {
  const auto found = std::ranges::find(scenes(), id, &SceneMaker::id);
  return found == scenes().end() ? nullptr : &*found;
}

const SceneMaker& scene_named(std::string_view id) { return entry_named(scenes(), "scene", id); }

}  // namespace fde
