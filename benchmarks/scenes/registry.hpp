#pragma once

#include <cstddef>
#include <deque>
#include <string_view>

#include "scenes/scene.hpp"

namespace fde {

// The scenes that there are, in order: those of scenes/list.def, then what is added at run time. A value: who
// adds scenes hands it to those that shall find them, and no one else sees them. Entries stay where they are
// as long as it lives, also when more are added.
class Scenes {
 public:
  Scenes();  // those of the list

  // Throws std::invalid_argument where there is one of this id, or the id is empty or holds the ':' behind
  // which a label has its settings.
  const SceneMaker& add(SceneMaker maker);

  [[nodiscard]] auto begin() const { return makers_.begin(); }
  [[nodiscard]] auto end() const { return makers_.end(); }
  [[nodiscard]] std::size_t size() const { return makers_.size(); }

 private:
  std::deque<SceneMaker> makers_;
};

// Those of the list alone.
const Scenes& scenes();

// The scene with this id, or nullptr.
const SceneMaker* find_scene(std::string_view id, const Scenes& among = scenes());

// The scene with this id. Throws std::invalid_argument naming the scenes that there are.
const SceneMaker& scene_named(std::string_view id, const Scenes& among = scenes());

}  // namespace fde
