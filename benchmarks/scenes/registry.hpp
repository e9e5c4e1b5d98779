#pragma once

#include <span>
#include <string_view>

#include "scenes/scene.hpp"

namespace fde {

// All scenes, in the order of the list.
std::span<const SceneMaker> scenes();

// The scene that a label of results names: "pendulum:alpha=1.9" is a pendulum. nullptr: none does.
const SceneMaker* scene_of_label(std::string_view label);

// The scene with this id, or nullptr.
const SceneMaker* find_scene(std::string_view id);

// The scene with this id. Throws std::invalid_argument naming the scenes that there are.
const SceneMaker& scene_named(std::string_view id);

}  // namespace fde
