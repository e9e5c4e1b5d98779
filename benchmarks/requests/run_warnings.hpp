// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/requests/requested_run.hpp"
#include "fdebench/benchmarks/requests/solve.hpp"

namespace fde::bench {

// What speaks against the numbers of a finished run over a grid. With check, the run is compared with one of
// half the steps in any case.
std::vector<Warning> run_warnings(const Scene& scene, const RequestedRun& run, const Trajectory& path,
                                  bool check);

// The same of a run with a tolerance that took so many seconds and gives this table: a tolerance below
// rounding, an error above it, events whose functions are a number at no time.
std::vector<Warning> run_warnings(const Scene& scene, const RequestedRun& run, const SolvedTable& table,
                                  const Trajectory& path, double seconds, bool check);

}  // namespace fde::bench
