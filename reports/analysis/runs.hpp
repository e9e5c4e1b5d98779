// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/reports/analysis/quantity_values.hpp"

namespace fde::bench {

// All values of one run, collected from its rows.
struct MeasuredRun {
  RunKey key{};
  int steps = 0;
  double h = 0.0;
  std::size_t session =
      0;  // of the times, or of the examination of a run without; index into Results::sessions
  RunOutcome ending{};
  ProgramFacts program{};  // what another program says of itself
  ColumnErrors columns{};  // what its errors are over, and those of single columns
  QuantityValues values{};
  std::map<std::string, Course, std::less<>> courses{};  // of the quantities that have one
  bool wall_clock = false;                               // the times are of whole processes
  bool first_run = false;                                // the times are of the first run of a process

  // The value of a quantity; nullopt: not measured.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const;
};

// The time of a solve. Results without an interval give [minimum, median]. nullopt if the run is not timed.
std::optional<MedianInterval> time_of(const MeasuredRun& run);

// The runs of a results file, ordered by scene, scheme (as in the lists of this build, unknown ones last) and
// setup, from coarse to fine. Errors of a scene are over the same columns (compare_over_common_columns). If a
// run was made in several sessions, the last one counts; its times may be from a later session of the same
// build.
struct Runs {
  std::vector<MeasuredRun> finished, failed;  // failed: any ending but `finished`, refusals included
  std::map<SceneSettings, SceneDescription>
      scenes{};  // what the file says of them, the last if it does twice
  std::map<SceneSettings, std::vector<std::string>>
      compared{};  // the columns that the errors of a scene are over; without entry: all its columns

  // The description of a scene; nullptr if the file has none.
  [[nodiscard]] const SceneDescription* describe(const SceneSettings& scene) const;
};

Runs runs_of(const Results& results);

// Makes each time that of the first run of a process, by what that takes longer, so that runs are ranked by
// it.
void count_first_runs(Runs& runs);

// The sessions and runs of a results file. Rows are not stored: they would take twice the size of the file.
// Throws std::invalid_argument naming the file if it contains no run, and as scan_results does.
struct ReadRuns {
  std::vector<Session> sessions{};
  Runs runs{};
  std::string warning{};  // of lines that are left out (ScanSummary)
};
ReadRuns read_runs(const std::filesystem::path& file);
ReadRuns read_runs(const Results& results);

// Contiguous runs: of the same scene; or of the same scene, scheme and setup except the resolution. The
// latter are a line of a chart, from coarse to fine. Precondition: `runs` has the order of Runs.
using RunSpan = std::span<const MeasuredRun>;
std::vector<RunSpan> by_scene(RunSpan runs);
std::vector<RunSpan> by_line(RunSpan runs);

// The contiguous runs of this scene; empty if there are none.
RunSpan of_scene(RunSpan runs, const SceneSettings& scene);

}  // namespace fde::bench
