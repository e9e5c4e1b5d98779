// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/reports/command/requested_run.hpp"

namespace fde::bench {

// What is printed of a run: at all its times, at the requested ones, or at its events; or of several
// solutions.
struct SolvedTable {
  std::vector<std::string> names{};
  std::vector<double> times{};
  std::optional<std::vector<std::string>> events{};  // at these times, where events are printed
  std::optional<std::vector<int>> solutions{};       // of each row, from 1, where all are printed
  std::string ended{};    // by which event and when the run ended before its end; empty: it did not
  Rows values{};          // one row a name, one column a time
  Rows field{};           // the unknowns, one column a time, where they are requested
  std::string warning{};  // of all that speaks against them; empty: nothing
  std::string cost{};     // one JSON object: time, calls, memory, rate
  std::filesystem::path checkpoint{};  // of no use once the table is written; empty: there is none
};

// Whether the columns at the printed times are all that a run has to keep: then neither reactions nor the
// field need states.
bool keeps_columns(const Scene& scene, const RequestedRun& run);

// The times at which a run has to return states: the printed ones, those beside them that the rates of
// reactions need, and those at which warnings compare it.
std::vector<double> times_to_return(const Scene& scene, const RequestedRun& run);

// The table of a path, its columns given at `times`. Throws NumericalFailure where a value is not finite.
SolvedTable table_of(const Scene& scene, const RequestedRun& run, const Trajectory& path,
                     const std::vector<double>& times, const Rows& columns);

// The events of a path in place of its times.
SolvedTable table_of_events(const Scene& scene, const Scheme& scheme, const Trajectory& path);

// Appends the rows of other solutions, and numbers all.
void add_others(SolvedTable& table, const Scene& scene, const RequestedRun& run,
                const std::vector<Trajectory>& others);

}  // namespace fde::bench
