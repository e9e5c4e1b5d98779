// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// What a run of a program is for: its errors, or the time of its solves.
enum class TaskPurpose { errors, times };

// The input of an external program as JSON; docs/external_solvers.md lists the fields. `times` are the output
// times. Preconditions: `scene` was made from `variant`, and settings.resolution is a number of steps.
std::string task_json(const SceneVariant& variant, const Scene& scene, const RunSettings& settings,
                      const std::vector<double>& times, TaskPurpose purpose);

}  // namespace fde::bench
