// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/external/external_program.hpp"
#include "fdebench/benchmarks/measures/own_measure.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/sweep/in_parallel.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/sweep/sweep_event.hpp"
#include "fdebench/benchmarks/sweep/sweep_plan.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// The runs of a sweep: every scheme, and after these every external program, takes the resolutions of the
// plan on every scene. Programs take numbers of steps only.
struct Sweep {
  std::vector<SceneVariant> scenes;
  std::vector<const Scheme*> schemes;
  std::vector<ExternalProgram> programs{};
  SweepPlan plan;
  RunSettings settings{.budget = 600.0};  // settings of all runs except the resolution
  bool optimal_grids = false;  // each scheme with optimal_grading() instead of the settings's grading
  std::vector<const Scheme*> graded{};  // these with both gradings, where solutions are not smooth at 0
  std::vector<OwnMeasure> measures{};   // of the caller, of the runs of schemes, beside ours
  TimingRepeats repeats{};
  bool describes_solutions = true;    // results have the reference solution of each scene
  bool examines_only = false;         // no run is timed
  bool retimes = false;               // disturbed times of earlier sweeps are measured again
  unsigned threads = usable_cores();  // for the untimed part
};

// Lookup of recorded runs.
using RecordedLookup = std::function<std::optional<Record>(const RunKey&)>;

// Callbacks of run_sweep(): lookup of recorded runs, output of examined runs and of the times of one that was
// output or recorded before, progress; lookup and output of scenes, which are not described without them. All
// but `recorded`, which several threads call, are called by one thread at a time.
struct SweepCallbacks {
  RecordedLookup recorded;
  std::function<void(const Record&)> append, append_times;
  std::function<void(const SweepEvent&)> on_event;
  std::function<bool(const SceneSettings&)> describes{};
  std::function<void(const SceneDescription&)> append_scene{};
};

// How often a run is timed at most where Sweep::retimes holds.
inline constexpr int most_timings = 3;

// Makes each run that is not recorded yet, once. In turns: the next runs, with a goal the shortest ones of
// each scene, are examined, one thread for all scenes with the same exact columns, which share a reference;
// their solves are timed, one at a time; then the plan decides, from recorded and new runs alike, which run
// of each refinement is the next, so that a resumed sweep makes the same runs. A run is passed to `append` as
// soon as it is examined, and to `append_times` when it is timed; before the first run of a scene its
// description is passed to `append_scene`, unless it is recorded. At one resolution the runs of a scene keep
// the order of the schemes; those of different scenes interleave, and only scenes_at_once scenes are in
// memory. The number of threads changes nothing but the times. An exception of one of the outputs ends the
// sweep and is rethrown.
inline constexpr std::size_t scenes_at_once = 256;
void run_sweep(const Sweep& requested, const SweepCallbacks& callbacks);

}  // namespace fde::bench
