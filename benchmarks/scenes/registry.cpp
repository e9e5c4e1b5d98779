// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/registry.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace fde::bench {

// Defined in the C++ of the scene, or for an equation file in the source that cmake/embed_scenes.cmake
// writes.
#define FDE_SCENE(id) SceneFactory id();
#include "fdebench/benchmarks/scenes/list.def"
#undef FDE_SCENE

// Cache of the scenes made by the loader.
struct SceneRegistry::LoadedScenes {
  std::mutex mutex;
  std::deque<SceneFactory> makers;
};

SceneRegistry::SceneRegistry()
    : factories_{
#define FDE_SCENE(id) id(),
#include "fdebench/benchmarks/scenes/list.def"
#undef FDE_SCENE
      },
      loaded_(std::make_shared<LoadedScenes>()) {
}

SceneRegistry::SceneRegistry(const SceneRegistry& others, SceneLoader finder)
    : factories_(others.factories_), loader_(std::move(finder)), loaded_(std::make_shared<LoadedScenes>()) {}

const SceneFactory& SceneRegistry::add(SceneFactory maker) {
  if (maker.id.empty() || maker.id.find(':') != std::string::npos)
    reject("id", maker.id, "a name without ':'");
  if (find_scene(maker.id, *this) != nullptr) reject("id", maker.id, "that of no other scene");
  return factories_.emplace_back(std::move(maker));
}

const SceneFactory& SceneRegistry::named(std::string_view id) const {
  const bool listed = find_scene(id, *this) != nullptr;
  if (listed || !loader_) return entry_by_id(factories_, "scene", id);
  const std::scoped_lock lock(loaded_->mutex);
  const auto before = std::ranges::find(loaded_->makers, id, &SceneFactory::id);
  if (before != loaded_->makers.end()) return *before;
  if (auto made = loader_(id)) return loaded_->makers.emplace_back(std::move(*made));
  return entry_by_id(factories_, "scene", id);
}

const SceneRegistry& built_in_scenes() {
  static const SceneRegistry of_the_list;
  return of_the_list;
}

const SceneFactory* find_scene(std::string_view id, const SceneRegistry& among) {
  const auto found = std::ranges::find(among, id, &SceneFactory::id);
  return found == among.end() ? nullptr : &*found;
}

}  // namespace fde::bench
