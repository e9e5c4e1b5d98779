// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fdebench/benchmarks/records/recorded_run.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"

namespace fde::bench {

// The purpose of a refinement: to find the cheapest run within each of these errors, in both norms (at the
// end time and maximum).
struct RefinementGoal {
  std::vector<double> errors{1e-2, 1e-4, 1e-6, 1e-8};
  double most_seconds = 0.3;  // of a solve; slower runs are not considered
  double margin = 2.0;        // safety factor for the forecast time of another scheme
};

// The resolutions (numbers of steps, tolerances) of the runs of a scheme on a scene, from coarse to fine.
// With a goal the refinement ends by is_finished().
struct RefinementPlan {
  std::vector<StepsOrTolerance> resolutions{};
  std::optional<RefinementGoal> goal{};
};

// The resolutions of the kind that a scheme takes: numbers of steps for grids, tolerances for adaptive step
// size. If there is none of that kind, all resolutions: the scheme refuses each.
RefinementPlan plan_for(const RefinementPlan& plan, const Capabilities& capabilities);

// A measured error and its theoretical rate.
struct ErrorWithRate {
  std::optional<double> error{}, rate{};
  bool is_stagnant = false;  // the error is dominated by rounding or by the error of the reference

  bool operator==(const ErrorWithRate&) const = default;
};

// The data of one run from which finer runs are forecast.
struct RefinementRun {
  int steps = 0;                       // 0: the run has a tolerance instead
  bool fails_with_more_steps = false;  // more steps would fail alike: refused, no reference, overflow, ...
  ErrorWithRate end{}, maximum{};      // absolute errors; on the mixed scale they are no larger
  std::optional<double> seconds{};     // of one solve
  bool wall_clock = false;             // `seconds` is the time of a whole process
};
using NormMember = ErrorWithRate RefinementRun::*;
// The data of a recorded run; the steps are those of its setup.
RefinementRun refinement_run(const RunSettings& setup, const RecordedRun& run);

// The runs so far of one scheme on a scene, from coarse to fine.
using Refinement = std::vector<RefinementRun>;

// The seconds of the cheapest run with an error <= `error`: measured, otherwise forecast from the last run's
// error and a rate. The rate is the smaller of the observed and the theoretical one; if `hopeful`, the larger
// plus 1/2. nullopt if no number of steps of the plan suffices, or error, time or rate is unknown.
std::optional<double> seconds_needed(const RefinementPlan& plan, const Refinement& refinement, NormMember of,
                                     double error, bool hopeful);

// Whether finer runs of `refinement`, an element of `of_scene`, cannot change the result of the sweep, so
// that the refinement ends. Without a goal it ends at the last resolution of the plan. With a goal it also
// ends
//   - if fails_with_more_steps is true of the last run;
//   - if the next run is forecast to take more than most_seconds (the start of a process not counted).
// With numbers of steps it also ends
//   - if the error is within the least error of the goal or is_stagnant, in both norms;
//   - from the fifth run on, if each error not reached yet is out of reach (hopeful forecast) or another
//     scheme reaches it in less time, measured or forecast, divided by the margin;
//   - from the fifth run on, if a scheme listed earlier has the same errors bit for bit: both schemes are the
//     same algorithm on this scene.
// With tolerances it also ends from the third run on, if for each error of the goal another scheme's measured
// time is less by the margin.
bool is_finished(const RefinementPlan& plan, std::span<const Refinement> of_scene,
                 const Refinement& refinement);

}  // namespace fde::bench
