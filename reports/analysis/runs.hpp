// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// The time of a solve. Results without an interval give [minimum, median]. nullopt if the run is not timed.
std::optional<MedianInterval> time_of(const Record& run);

// The runs of a results file, ordered by scene, scheme (as in the lists of this build, unknown ones last) and
// settings, from coarse to fine. Errors of a scene are over the same columns (compare_over_common_columns).
// If a run was examined in several sessions, the last one counts.
struct Runs {
  std::vector<Record> finished, failed;  // failed: any ending but `finished`, refusals included
  std::map<SceneSettings, SceneDescription>
      scenes{};  // what the file says of them, the last if it does twice
  std::map<SceneSettings, std::vector<std::string>>
      compared{};  // the columns that the errors of a scene are over; without entry: all its columns

  // The description of a scene; nullptr if the file has none.
  [[nodiscard]] const SceneDescription* describe(const SceneSettings& scene) const;
};

Runs runs_of(Results results);

// Makes each time that of the first run of a process, by what that takes longer, so that runs are ranked by
// it.
void count_first_runs(Runs& runs);

// The sessions and runs of a results file. Throws std::invalid_argument naming the file if it contains no
// run, and as read_results does.
struct ReadRuns {
  std::vector<Session> sessions{};
  Runs runs{};
  std::string warning{};  // of lines that are left out
};
ReadRuns read_runs(const std::filesystem::path& file);
ReadRuns read_runs(Results results);

// Contiguous runs: of the same scene; or of the same scene, scheme and settings except the resolution. The
// latter are a line of a chart, from coarse to fine. Precondition: `runs` has the order of Runs.
using RunSpan = std::span<const Record>;
std::vector<RunSpan> by_scene(RunSpan runs);
std::vector<RunSpan> by_line(RunSpan runs);

// The contiguous runs of this scene; empty if there are none.
RunSpan of_scene(RunSpan runs, const SceneSettings& scene);

}  // namespace fde::bench
