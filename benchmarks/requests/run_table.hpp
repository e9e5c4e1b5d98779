// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/requests/requested_run.hpp"
#include "fdebench/benchmarks/requests/solve.hpp"

namespace fde::bench {

// The times at which a run has to return states: the requested ones, those beside them that the rates of
// reactions need, and those at which warnings compare it.
std::vector<double> times_to_return(const Scene& scene, const RequestedRun& run);

// The table of a path, its columns given at `times`. Throws NumericalFailure where a value is not finite.
SolvedTable table_of(const Scene& scene, const RequestedRun& run, const Trajectory& path,
                     const std::vector<double>& times, const Rows& columns);

// The events of a path in place of its times. Throws NumericalFailure where a value is not finite.
SolvedTable table_of_events(const Scene& scene, const Scheme& scheme, const Trajectory& path);

}  // namespace fde::bench
