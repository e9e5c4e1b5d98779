// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/search/next_resolution.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// Which runs of each refinement (a scheme with a grading, or a program) a sweep makes: with a goal those that
// next_resolutions() chooses; otherwise these resolutions (numbers of steps, tolerances), in this order.
struct SweepPlan {
  std::vector<StepsOrTolerance> resolutions{};
  std::optional<SearchGoal> goal{};
};

// The plan's resolutions of the kind that a scheme takes: numbers of steps for grids, tolerances for adaptive
// step size. If there is none of that kind, all: the scheme refuses each.
std::vector<StepsOrTolerance> resolutions_for(const SweepPlan& plan, const Capabilities& capabilities);

// The kinds of error of a sweep, indices of RefinementRun::errors: on the mixed scale, at the end time and
// over all times.
inline constexpr std::size_t error_at_end = 0, error_maximum = 1;

// A recorded run as the choice of the next one sees it.
RefinementRun refinement_run(const Record& run);

// The next run of each refinement of a scene; nullopt where it has ended. `listed`: its resolutions_for().
std::vector<std::optional<StepsOrTolerance>> next_runs(const SweepPlan& plan,
                                                       std::span<const std::vector<StepsOrTolerance>> listed,
                                                       std::span<const Refinement> of_scene);

}  // namespace fde::bench
