// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/search/search_goal.hpp"

namespace fde::bench {

// The next number of steps of a configuration over grids that has runs, seen against one target: doubled
// until a run is within it, then the bracket of the fewest steps within it is closed. `quickest`: the seconds
// of the quickest run within the target; `least_step`: those of the cheapest step of any configuration.
NextRun next_steps(const SearchGoal& goal, const Refinement& of, const ErrorTarget& target, double quickest,
                   double least_step, const IsOutOfReach& is_out_of_reach);

}  // namespace fde::bench
