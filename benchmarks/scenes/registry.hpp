#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "scenes/scene.hpp"

namespace fde {

// A list of scenes: those of scenes/list.def in order, then the scenes added at run time. Scenes are passed
// by value or reference, not registered globally. References to entries remain valid while the object lives,
// also after add().
class Scenes {
 public:
  // Makes a scene from a name that is not in the list, such as a file name; nullopt if the name is unknown.
  using Finder = std::function<std::optional<SceneMaker>(std::string_view name)>;

  Scenes();                                     // the scenes of scenes/list.def
  Scenes(const Scenes& others, Finder finder);  // and those that `finder` makes on request

  // Throws std::invalid_argument if a scene has this id, or if the id is empty or contains ':', which
  // separates an id from its settings.
  const SceneMaker& add(SceneMaker maker);

  // The scene with this id, or the scene that the finder makes from it (cached). Throws std::invalid_argument
  // naming the existing scenes, and whatever the finder throws.
  [[nodiscard]] const SceneMaker& named(std::string_view id) const;

  // Scenes made by the finder are not in the range.
  [[nodiscard]] auto begin() const { return makers_.begin(); }
  [[nodiscard]] auto end() const { return makers_.end(); }
  [[nodiscard]] std::size_t size() const { return makers_.size(); }

 private:
  struct Found;

  std::deque<SceneMaker> makers_;
  Finder finder_{};
  std::shared_ptr<Found> found_;
};

// The scenes of scenes/list.def.
const Scenes& scenes();

// The scene with this id, or nullptr.
const SceneMaker* find_scene(std::string_view id, const Scenes& among = scenes());

}  // namespace fde
