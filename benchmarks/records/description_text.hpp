// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "fdebench/benchmarks/records/scene_description.hpp"

namespace fde::bench {

// The value of `scene` in the line of a scene, and its inverse, which throws std::exception if a field is
// missing or has another type. Unknown fields are ignored.
nlohmann::json json_of(const SceneDescription& scene);
SceneDescription description_of(const nlohmann::json& fields);

// t, columns, values, bound; energy, reactions and motion, each with columns and values of its own. Values
// above 1e300 in size are null: the extent of a chart's axis would overflow.
nlohmann::json json_of(const SampledSolution& solution);

}  // namespace fde::bench
