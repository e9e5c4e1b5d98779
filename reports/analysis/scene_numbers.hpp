// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The name of the end time among the parameters of a scene.
inline constexpr auto end_name = "until";

// The scene with the defaults of its missing parameters, if the results describe it.
SceneSettings with_defaults(const Runs& runs, SceneSettings scene);

// The scene without a parameter, or without the end time.
SceneSettings without(SceneSettings scene, const std::string& parameter);

// The scenes of all runs.
std::set<SceneSettings> scenes_of(const Runs& runs);

// The numeric parameters of a scene by name, the end time included.
std::map<std::string, double> numbers_of(const SceneSettings& scene);

}  // namespace fde::bench
