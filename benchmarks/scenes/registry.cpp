#include "scenes/registry.hpp"

#include <algorithm>
#include <utility>

namespace fde {

#define FDE_SCENE(id) SceneMaker id();
#include "scenes/list.def"
#undef FDE_SCENE

Scenes::Scenes()
    : makers_{
#define FDE_SCENE(id) id(),
#include "scenes/list.def"
#undef FDE_SCENE
      } {
}

const SceneMaker& Scenes::add(SceneMaker maker) {
  if (maker.id.empty() || maker.id.find(':') != std::string::npos)
    reject("id", maker.id, "a name without ':'");
  if (find_scene(maker.id, *this) != nullptr) reject("id", maker.id, "that of no other scene");
  return makers_.emplace_back(std::move(maker));
}

const Scenes& scenes() {
  static const Scenes of_the_list;
  return of_the_list;
}

const SceneMaker* find_scene(std::string_view id, const Scenes& among) {
  const auto found = std::ranges::find(among, id, &SceneMaker::id);
  return found == among.end() ? nullptr : &*found;
}

const SceneMaker& scene_named(std::string_view id, const Scenes& among) {
  return entry_named(among, "scene", id);
}

}  // namespace fde
