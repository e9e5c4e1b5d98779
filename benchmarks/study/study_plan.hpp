// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/study/study.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"

namespace fde::bench {

// The expected runs, seconds in one thread, and bytes in a results file.
struct PlannedWork {
  std::size_t scenes = 0, runs = 0;
  ExpectedSeconds seconds{};
  double bytes = 0.0;

  PlannedWork& operator+=(const PlannedWork& other);
};

// The work of each scene. The bytes are those of usual numbers of rows.
using PlannedScenes = std::map<SceneSettings, PlannedWork>;
PlannedScenes planned_scenes(const Forecast& expected);

PlannedWork sum_of(const PlannedScenes& scenes);

// A part of a study, a study itself, with its work.
struct StudyShard {
  Study study{};
  PlannedWork work{};
};

// The study in at most `count` parts that take about the same time: the longest scene first, each to the part
// that has least to do. A scene is in one part with all its runs; the families keep their order. Parts
// without a scene are left out.
std::vector<StudyShard> shards_of(const Study& study, const PlannedScenes& scenes, int count);

// Writes a file for each part into the folder, in place of those of an earlier plan, and plan.json: the study
// with its checksum, and of each part the file, scenes, runs, seconds_examine, seconds_time and bytes. An
// earlier plan is removed when all is written. Throws std::invalid_argument naming a path that cannot be
// written.
void write_plan(const Study& study, const std::vector<StudyShard>& shards,
                const std::filesystem::path& folder);

}  // namespace fde::bench
