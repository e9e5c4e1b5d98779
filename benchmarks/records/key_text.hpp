// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// The fields of a line of a results file that identify a scene or a run. What is the default is left out.
nlohmann::json json_of(const SceneSettings& scene);
nlohmann::json json_of(const RunKey& run);

// Each throws std::invalid_argument for a value that is not allowed, and another std::exception if a field is
// missing or has another type.
SceneSettings scene_of(const nlohmann::json& line);
RunKey run_of(const nlohmann::json& line);

// A tolerance as `relative` and `absolute`.
nlohmann::json json_of(const Tolerance& accuracy);
Tolerance tolerance_of(const nlohmann::json& accuracy);

// A number of steps from `fewest` on.
int steps_of(const nlohmann::json& line, int fewest);

// The number in the fewest digits that read back to it: a whole one without a point.
nlohmann::json number_of(double value);

}  // namespace fde::bench
