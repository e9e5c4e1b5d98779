#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scenes/variant.hpp"

namespace fde {

// The page's data with one section: of what a figure shows. All throw std::invalid_argument where there is
// nothing to show.

// The runs of a scene in a results file.
nlohmann::json data_of_runs(const std::string& results, const SceneVariant& of, const Scenes& known);

// The drifts of a scene in all its formulations.
nlohmann::json data_of_drifts(const std::string& results, const SceneVariant& of, const Scenes& known);

// The reference; of several scenes, which differ in one parameter, a family of them.
nlohmann::json data_of_solutions(const std::vector<SceneVariant>& scenes);

// The regions of stability of all schemes at the order of the scene.
nlohmann::json data_of_regions(const SceneVariant& of);

}  // namespace fde
