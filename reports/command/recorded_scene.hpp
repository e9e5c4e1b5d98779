// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The scene of the runs of --results that a text and the settings of --set name. A scene that this build does
// not have, and an equation file that does not exist, are found by their name and settings, whatever the
// checksum. Throws std::invalid_argument if there is no such scene or more than one; for an unknown name as
// read_variant does. Scenes that differ in the parameter `any` only are one, which is returned without it.
SceneSettings recorded_scene(const Runs& runs, const std::string& results, const std::string& text,
                             const std::vector<std::string>& settings, const SceneRegistry& known,
                             const std::string& any = "");

}  // namespace fde::bench
