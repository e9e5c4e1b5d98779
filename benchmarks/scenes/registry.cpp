// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/registry.hpp"

#include <algorithm>
#include <deque>
#include <mutex>
#include <string>
#include <utility>

#include "fdebench/benchmarks/text/entry_named.hpp"

namespace fde::bench {

// Defined in the C++ of the scene, or for an equation file in the source that cmake/embed_scenes.cmake
// writes.
#define FDE_SCENE(id) SceneFactory id();
#include "fdebench/benchmarks/scenes/list.def"
#undef FDE_SCENE

struct SceneRegistry::Entry {
  Entry(std::string of, std::function<SceneFactory()> how) : id(std::move(of)), make(std::move(how)) {}
  const std::string id;
  const std::function<SceneFactory()> make;
  std::once_flag is_made{};
  std::optional<SceneFactory> scene{};
};

// Cache of the scenes made by the loader.
struct SceneRegistry::LoadedScenes {
  std::mutex mutex;
  std::deque<SceneFactory> factories;
};

SceneRegistry::SceneRegistry()
    : entries_{
#define FDE_SCENE(id) std::make_shared<Entry>(#id, id),
#include "fdebench/benchmarks/scenes/list.def"
#undef FDE_SCENE
      },
      loaded_(std::make_shared<LoadedScenes>()) {
}

SceneRegistry::SceneRegistry(const SceneRegistry& others, SceneLoader loader)
    : entries_(others.entries_), loader_(std::move(loader)), loaded_(std::make_shared<LoadedScenes>()) {}

const SceneFactory& SceneRegistry::scene_of(Entry& entry) {
  std::call_once(entry.is_made, [&] { entry.scene = entry.make(); });
  return *entry.scene;
}

const std::shared_ptr<SceneRegistry::Entry>* SceneRegistry::find(std::string_view id) const {
  const auto found = std::ranges::find(entries_, id, [](const auto& entry) { return entry->id; });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string_view> SceneRegistry::ids() const {
  std::vector<std::string_view> ids;
  for (const auto& entry : entries_) ids.emplace_back(entry->id);
  return ids;
}

const SceneFactory& SceneRegistry::add(SceneFactory factory) {
  if (factory.id.empty() || factory.id.find(':') != std::string::npos)
    reject("id", factory.id, "a name without ':'");
  if (find(factory.id) != nullptr) reject("id", factory.id, "that of no other scene");
  const std::string id = factory.id;
  entries_.push_back(std::make_shared<Entry>(id, [factory = std::move(factory)] { return factory; }));
  return scene_of(*entries_.back());
}

const SceneFactory& SceneRegistry::named(std::string_view id) const {
  if (const auto* const listed = find(id)) return scene_of(**listed);
  if (!loader_) throw_unknown_id("scene", id, ids());
  const std::scoped_lock lock(loaded_->mutex);
  const auto before = std::ranges::find(loaded_->factories, id, &SceneFactory::id);
  if (before != loaded_->factories.end()) return *before;
  if (auto made = loader_(id)) return loaded_->factories.emplace_back(std::move(*made));
  throw_unknown_id("scene", id, ids());
}

const SceneRegistry& built_in_scenes() {
  static const SceneRegistry of_the_list;
  return of_the_list;
}

const SceneFactory* find_scene(std::string_view id, const SceneRegistry& among) {
  const auto* const found = among.find(id);
  return found == nullptr ? nullptr : &SceneRegistry::scene_of(**found);
}

}  // namespace fde::bench
