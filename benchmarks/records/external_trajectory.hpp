// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/judge.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// What a program says of its solve in comments, lines `# KEY: VALUE` before the header of its output.
struct ProgramReport {
  ProgramFacts facts{};           // code (with the version), language
  std::optional<double> first{};  // duration of the first solve of the process
  std::vector<double> seconds{};  // durations of the solves, or with `first` of the later ones
  bool chooses_times = false;     // "times: own": the rows are at the times of the program
};

// A trajectory written by another program, or measured.
struct ExternalTrajectory {
  std::vector<Eigen::Index> columns{};  // indices of its columns among those of the scene
  std::vector<double> times{};          // increasing, the last above 0; of measurements also equal ones
  Rows values{};                        // one row a column, one column a time; NaN: not measured
  Rows deviations{};                    // standard deviations of the values; empty: not known
  ProgramReport report{};
};

// Computed values are one at each time. Measurements may be repeated at a time, and missing.
enum class TrajectorySource { computed, measured };

// Reads CSV with the header t,COLUMN,... and one row a time, in [0, end] of the scene. The columns are
// columns of the scene, in any order; other columns that `solve` prints are ignored. A value may be infinite
// or NaN, a time may not. `sd_COLUMN` has the standard deviations of COLUMN, above 0; either all columns have
// them or none. In measurements times may be equal, and a cell may be empty or nan, which is a missing value.
// Accepted are quoted names, a # before the header, spaces around cells, \r\n, empty
// lines at the end, and the comments of a ProgramReport. Throws std::invalid_argument naming file and
// line for anything else, and for more than 10 million values. `name` is the name in messages, by default the
// path.
ExternalTrajectory read_trajectory(const std::filesystem::path& file, const Scene& scene,
                                   const std::string& name = "",
                                   TrajectorySource source = TrajectorySource::computed);

// The same from numbers: the names after t, and rows of a time and a number for each name. Throws
// std::invalid_argument naming the row, counted from 1.
ExternalTrajectory measured_trajectory(const Scene& scene, const std::vector<std::string>& names,
                                       const std::vector<std::vector<double>>& rows);

// The comments at the beginning of the file of a program that failed; none after the first that is wrong.
ProgramReport read_report(const std::filesystem::path& file);

// The times at which a run of as many steps is judged: all if there are at most 8192 or a value is not
// finite, otherwise 8192 and the first 16.
ExternalTrajectory at_comparison_times(const ExternalTrajectory& path);

// Judges the trajectory at all of its times, with a reference for all columns of the scene. It ends at the
// first value that is not finite. If columns of the scene are missing, the ending's detail names those that
// are present.
Assessment judge_trajectory(const Scene& scene, const ExternalTrajectory& path, MemoizedReference& reference);

}  // namespace fde::bench
