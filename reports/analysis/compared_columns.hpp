// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// Makes the errors of the scene's runs those over these columns, as Runs::compared then says. Runs whose
// errors over them are not recorded go to `failed`.
void compare_over(Runs& runs, const SceneSettings& scene, const std::vector<std::string>& columns);

// Compares like with like: where a program was judged over some of a scene's columns, all runs of the scene
// are compared over the columns that they have in common. Where there is none, or the runs have no errors of
// single columns, the programs with fewer columns go to `failed`.
void compare_over_common_columns(Runs& runs);

// Says which programs were judged over other columns, so that their runs of the scene are not compared;
// empty: none.
std::string not_compared_text(const Runs& runs, const SceneSettings& scene);

// What the errors of the scene are over: "x, dx"; empty: all its columns.
std::string compared_text(const Runs& runs, const SceneSettings& scene);

}  // namespace fde::bench
