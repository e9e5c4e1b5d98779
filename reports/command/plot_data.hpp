// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "fdebench/benchmarks/records/external_trajectory.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The JSON data of the page, restricted to one section, for a figure. All throw std::invalid_argument if
// there is nothing to draw.

// The runs of a scene.
nlohmann::json data_of_runs(ReadRuns read, const SceneSettings& scene);

// The drifts of a scene in all its formulations.
nlohmann::json data_of_drifts(ReadRuns read, const SceneSettings& scene);

// The reference solution; for several scenes a family over the one parameter in which they differ.
nlohmann::json data_of_solutions(const std::vector<SceneVariant>& scenes, bool with_all_columns);

// Measurements, the reference solution up to the last of them, and what it leaves of them.
nlohmann::json data_of_measurements(SceneVariant scene, const ExternalTrajectory& measured);

// The stability regions of all schemes for the order of the scene.
nlohmann::json data_of_regions(const SceneVariant& of);

}  // namespace fde::bench
