// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A list of scenes: those of scenes/list.def in order, then the scenes added at run time. Scenes are passed
// by value or reference, not registered globally. Each is made when it is first named or passed in a range;
// copies share it. References to entries remain valid while the object lives, also after add(). Thread-safe
// but for add().
class SceneRegistry {
  struct Entry;

 public:
  // Makes a scene from a name that is not in the list, such as a file name; nullopt if the name is unknown.
  using SceneLoader = std::function<std::optional<SceneFactory>(std::string_view name)>;

  SceneRegistry();                                                 // the scenes of scenes/list.def
  SceneRegistry(const SceneRegistry& others, SceneLoader loader);  // and those that `loader` makes on request

  // Throws std::invalid_argument if a scene has this id, or if the id is empty or contains ':', which
  // separates an id from its settings.
  const SceneFactory& add(SceneFactory factory);

  // The scene with this id, or the scene that the loader makes from it (cached). Throws std::invalid_argument
  // naming the existing scenes, and whatever the loader throws.
  [[nodiscard]] const SceneFactory& named(std::string_view id) const;

  // The ids in order, without making a scene.
  [[nodiscard]] std::vector<std::string_view> ids() const;

  // Scenes made by the loader are not in the range.
  class Iterator {
   public:
    using value_type = SceneFactory;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    explicit Iterator(const std::shared_ptr<Entry>* entry) : entry_(entry) {}
    const SceneFactory& operator*() const { return scene_of(**entry_); }
    const SceneFactory* operator->() const { return &scene_of(**entry_); }
    Iterator& operator++() {
      ++entry_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(entry_++); }
    bool operator==(const Iterator&) const = default;

   private:
    const std::shared_ptr<Entry>* entry_ = nullptr;
  };
  [[nodiscard]] Iterator begin() const { return Iterator(entries_.data()); }
  [[nodiscard]] Iterator end() const { return Iterator(entries_.data() + entries_.size()); }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

 private:
  struct LoadedScenes;

  static const SceneFactory& scene_of(Entry& entry);
  [[nodiscard]] const std::shared_ptr<Entry>* find(std::string_view id) const;
  friend const SceneFactory* find_scene(std::string_view id, const SceneRegistry& among);

  std::vector<std::shared_ptr<Entry>> entries_;
  SceneLoader loader_{};
  std::shared_ptr<LoadedScenes> loaded_;
};

// The scenes of scenes/list.def.
const SceneRegistry& built_in_scenes();

// The scene with this id, or nullptr.
const SceneFactory* find_scene(std::string_view id, const SceneRegistry& among = built_in_scenes());

}  // namespace fde::bench
