// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace fde::bench {

// The ids of the scenes of scenes/list.def, in order, without making a scene.
std::span<const std::string_view> scene_ids();

}  // namespace fde::bench
