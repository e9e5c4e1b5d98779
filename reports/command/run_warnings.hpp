// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/reports/command/printed_table.hpp"

namespace fde::bench {

// What speaks against the numbers of a finished run over a grid, as one line; empty where nothing does. With
// check, the run is compared with one of half the steps in any case.
std::string warning_line(const Scene& scene, const RequestedRun& run, const Trajectory& path, bool check);

// The same of a run with a tolerance that took so many seconds and is printed as this table: a tolerance
// below rounding, an error above it, events whose functions are a number at no time.
std::string warning_line(const Scene& scene, const RequestedRun& run, const SolvedTable& table,
                         const Trajectory& path, double seconds, bool check);

}  // namespace fde::bench
