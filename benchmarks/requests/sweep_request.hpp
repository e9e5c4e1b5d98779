// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/external/external_program.hpp"
#include "fdebench/benchmarks/measures/own_measure.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/range.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

struct Sweep;

inline constexpr CountRange repeat_counts{1, 1000};

// The seconds that a solve may take: with given resolutions; in a thorough sweep; otherwise. Schemes with
// adaptive step size may need very many steps on unsuitable problems.
inline constexpr double budget_of_listed_runs = 600.0, budget_of_thorough_runs = 60.0, budget_of_search = 1.0;

// What is asked of a sweep. In messages its fields are scene, scheme, external, steps, accuracy, grid,
// repeat, thorough, trials, examine, undisturbed, and, of the caller, schemes and measures.
struct SweepRequest {
  std::vector<SceneVariant> scenes{};           // empty: those of sweep_scenes()
  std::vector<const Scheme*> schemes{};         // empty: all of ours, or none beside programs
  std::vector<ExternalProgram> programs{};      // after the schemes
  std::vector<OwnMeasure> measures{};           // of the caller, of the runs of schemes, beside ours
  std::vector<StepsOrTolerance> resolutions{};  // empty: the cheapest runs are searched
  RunSettings settings{};                       // of all runs, but for the resolution and the budget
  bool optimal_grading = false;    // takes that of optimal_grading() in place of settings.grading
  std::optional<double> budget{};  // seconds of a solve; nullopt: as above
  int repeats = 3;                 // how often a run is timed
  bool thorough = false;           // all numbers of steps, all tolerances and all trials
  bool trials = false;             // only the stiff and extreme trials
  bool examine = false;            // times nothing
  bool undisturbed = false;        // repeats times that other work disturbed
};

// The sweeps that make these runs, the trials in sweeps of their own. Without scenes and resolutions the
// trials are among them. Throws Refusal where the fields exclude each other.
std::vector<Sweep> sweeps_of(const SweepRequest& request);

}  // namespace fde::bench
