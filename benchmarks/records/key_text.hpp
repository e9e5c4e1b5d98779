// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// The fields `scene`, `checksum` and `settings` of a line of a results file.
nlohmann::json json_of(const SceneSettings& scene);

// Throws std::invalid_argument for an empty checksum, and another std::exception if a field is missing or has
// another type.
SceneSettings scene_of(const nlohmann::json& line);

}  // namespace fde::bench
