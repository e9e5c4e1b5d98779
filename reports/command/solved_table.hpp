// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
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

// The times at which a run has to return states: the printed ones, those beside them that the rates of
// reactions need, and those at which warnings compare it.
std::vector<double> times_to_return(const Scene& scene, const RequestedRun& run);

// The table of a path, its columns given at `times`. Throws NumericalFailure where a value is not finite.
SolvedTable table_of(const Scene& scene, const RequestedRun& run, const Trajectory& path,
                     const std::vector<double>& times, const Rows& columns);

// A run that did not come to its end.
struct RunFailure : NumericalFailure {
  RunFailure(const std::string& message, std::string_view scheme_id, const Trajectory& path)
      : NumericalFailure(message), scheme(scheme_id), step(path.steps + 1), time(path.failure_time) {}
  std::string scheme;
  std::int64_t step;           // without a result
  std::optional<double> time;  // of that step
};

// Solves a scene. A checkpoint that cannot be written is not thrown but said. `show` is called now and then
// with the progress of the run. Throws std::invalid_argument naming the argument, the text and what is
// allowed, RunFailure, and NumericalFailure where a column is not finite.
SolvedTable solved_table(const Scene& scene, const Given& given,
                         const std::function<void(const std::string&)>& say = {},
                         const std::function<void(const Progress&)>& show = {});

// What speaks against the numbers of a finished run over a grid, as one line; empty where nothing does. With
// check, the run is compared with one of half the steps in any case.
std::string warning_line(const Scene& scene, const RequestedRun& run, const Trajectory& path, bool check);

// The same of a run with a tolerance that took so many seconds and is printed as this table: a tolerance
// below rounding, an error above it, events whose functions are a number at no time.
std::string warning_line(const Scene& scene, const RequestedRun& run, const SolvedTable& table,
                         const Trajectory& path, double seconds, bool check);

}  // namespace fde::bench
