// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/search/search_goal.hpp"

namespace fde::bench {

// The next tolerance of a configuration with adaptive step size that has runs, seen against one target:
// divided by ten, then those next to the tolerance of its quickest run within the target. `quickest`: the
// seconds of the quickest run of any configuration within it.
NextRun next_tolerance(const SearchGoal& goal, const Refinement& of, const ErrorTarget& target,
                       double quickest, const IsOutOfReach& is_out_of_reach);

}  // namespace fde::bench
