// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/study/study.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/reports/command/given.hpp"

namespace fde::bench {

// The requested sweep. With --trials the trials only; without scenes and steps the trials as well. With
// --study the sweeps of the study, or of the shard of it. Throws std::invalid_argument naming the argument,
// the text and what is allowed.
std::vector<Sweep> sweeps_of(const Given& given, const SceneRegistry& known);

// One sweep for all families with the same settings, in the order of the file. Results do without the
// solutions of scenes. Throws std::invalid_argument naming file, line and column, the key, its value and what
// is allowed.
std::vector<Sweep> sweeps_of(const Study& study);

// The declaration of --budget has this default.
std::string budget_of_sweeps_text();

// Whether the forecast number of runs is exact: with a goal the refinement may end elsewhere than forecast.
bool count_is_exact(const std::vector<Sweep>& sweeps);

}  // namespace fde::bench
