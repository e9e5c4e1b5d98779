// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/search/next_resolution.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// Which runs of each refinement (a scheme with a grading, or a program) a sweep makes: with a goal those that
// next_resolutions() and due_runs() choose; otherwise these resolutions (numbers of steps, tolerances), in
// this order.
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

}  // namespace fde::bench
