// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A list of scenes: those of scenes/list.def in order, then the scenes added at run time. Scenes are passed
// by value or reference, not registered globally. References to entries remain valid while the object lives,
// also after add().
class SceneRegistry {
 public:
  // Makes a scene from a name that is not in the list, such as a file name; nullopt if the name is unknown.
  using SceneLoader = std::function<std::optional<SceneFactory>(std::string_view name)>;

  SceneRegistry();                                                 // the scenes of scenes/list.def
  SceneRegistry(const SceneRegistry& others, SceneLoader finder);  // and those that `finder` makes on request

  // Throws std::invalid_argument if a scene has this id, or if the id is empty or contains ':', which
  // separates an id from its settings.
  const SceneFactory& add(SceneFactory maker);

  // The scene with this id, or the scene that the loader makes from it (cached). Throws std::invalid_argument
  // naming the existing scenes, and whatever the loader throws.
  [[nodiscard]] const SceneFactory& named(std::string_view id) const;

  // Scenes made by the loader are not in the range.
  [[nodiscard]] auto begin() const { return factories_.begin(); }
  [[nodiscard]] auto end() const { return factories_.end(); }
  [[nodiscard]] std::size_t size() const { return factories_.size(); }

 private:
  struct LoadedScenes;

  std::deque<SceneFactory> factories_;
  SceneLoader loader_{};
  std::shared_ptr<LoadedScenes> loaded_;
};

// The scenes of scenes/list.def.
const SceneRegistry& built_in_scenes();

// The scene with this id, or nullptr.
const SceneFactory* find_scene(std::string_view id, const SceneRegistry& among = built_in_scenes());

}  // namespace fde::bench
