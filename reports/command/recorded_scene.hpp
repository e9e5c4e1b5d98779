// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/command/arguments.hpp"

namespace fde::bench {

// The scene of the runs of --results that the arguments name. A scene that this build does not have, and an
// equation file that does not exist, are found by their name and settings, whatever the checksum. Throws
// std::invalid_argument if there is no such scene or more than one; for an unknown name as read_variant does.
// Scenes that differ in the parameter `any` only are one, which is returned without it.
SceneSettings recorded_scene(const Runs& runs, const std::string& results, const SceneArguments& arguments,
                             const SceneRegistry& known, const std::string& any = "");

}  // namespace fde::bench
