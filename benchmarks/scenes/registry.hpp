#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "scenes/scene.hpp"

namespace fde {

// The scenes that there are, in order: those of scenes/list.def, then what is added at run time. A value: who
// adds scenes hands it to those that shall find them, and no one else sees them. Entries stay where they are
// as long as it lives, also when more are added.
class Scenes {
 public:
  // Makes a scene of a name that is no id of the list, such as that of a file; nothing: of none of its names.
  using Finder = std::function<std::optional<SceneMaker>(std::string_view name)>;

  Scenes();                                     // those of the list
  Scenes(const Scenes& others, Finder finder);  // and those that the finder makes when they are named

  // Throws std::invalid_argument where there is one of this id, or the id is empty or holds the ':' behind
  // which a label has its settings.
  const SceneMaker& add(SceneMaker maker);

  // The scene with this id, or the one that the finder makes of it, once. Throws std::invalid_argument naming
  // the scenes that there are, and what the finder throws.
  [[nodiscard]] const SceneMaker& named(std::string_view id) const;

  // Those that the finder makes are not among these.
  [[nodiscard]] auto begin() const { return makers_.begin(); }
  [[nodiscard]] auto end() const { return makers_.end(); }
  [[nodiscard]] std::size_t size() const { return makers_.size(); }

 private:
  struct Found;

  std::deque<SceneMaker> makers_;
  Finder finder_{};
  std::shared_ptr<Found> found_;
};

// Those of the list alone.
const Scenes& scenes();

// The scene with this id, or nullptr.
const SceneMaker* find_scene(std::string_view id, const Scenes& among = scenes());

}  // namespace fde
