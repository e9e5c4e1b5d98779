#include "scenes/registry.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace fde {

#define FDE_SCENE(id) SceneMaker id();
#include "scenes/list.def"
#undef FDE_SCENE

// Cache of the scenes made by the finder.
struct Scenes::Found {
  std::mutex mutex;
  std::deque<SceneMaker> makers;
};

Scenes::Scenes()
    : makers_{
#define FDE_SCENE(id) id(),
#include "scenes/list.def"
#undef FDE_SCENE
      },
      found_(std::make_shared<Found>()) {
}

Scenes::Scenes(const Scenes& others, Finder finder)
    : makers_(others.makers_), finder_(std::move(finder)), found_(std::make_shared<Found>()) {}

const SceneMaker& Scenes::add(SceneMaker maker) {
  if (maker.id.empty() || maker.id.find(':') != std::string::npos)
    reject("id", maker.id, "a name without ':'");
  if (find_scene(maker.id, *this) != nullptr) reject("id", maker.id, "that of no other scene");
  return makers_.emplace_back(std::move(maker));
}

const SceneMaker& Scenes::named(std::string_view id) const {
  const bool listed = find_scene(id, *this) != nullptr;
  if (listed || !finder_) return entry_named(makers_, "scene", id);
  const std::scoped_lock lock(found_->mutex);
  const auto before = std::ranges::find(found_->makers, id, &SceneMaker::id);
  if (before != found_->makers.end()) return *before;
  if (auto made = finder_(id)) return found_->makers.emplace_back(std::move(*made));
  return entry_named(makers_, "scene", id);
}

const Scenes& scenes() {
  static const Scenes of_the_list;
  return of_the_list;
}

const SceneMaker* find_scene(std::string_view id, const Scenes& among) {
  const auto found = std::ranges::find(among, id, &SceneMaker::id);
  return found == among.end() ? nullptr : &*found;
}

}  // namespace fde
