// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/reports/command/given.hpp"

namespace fde::bench {

// The requested sweeps: of the options, or of a study, whole or the shard of them. Throws
// std::invalid_argument naming the argument, the text and what is allowed.
std::vector<Sweep> sweeps_of(const Given& given, const SceneRegistry& known);

// The declaration of --budget has this default.
std::string budget_of_sweeps_text();

// Whether the forecast number of runs is exact: with a goal the refinement may end elsewhere than forecast.
bool count_is_exact(const std::vector<Sweep>& sweeps);

}  // namespace fde::bench
