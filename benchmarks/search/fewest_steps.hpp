// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/search/candidate_run.hpp"

namespace fde::bench {

// The run with about the fewest steps (to 1.5 %) whose error is within the accuracy; `attempt` makes a run.
// Precondition: of `refinements`, runs with doubled steps, only the last is within the accuracy. Numbers of
// steps are multiples of `unit`. With `scan` the steps are also decreased by a factor of 1.05 down to a
// sixteenth, and sign changes of the error in between are searched: an error that passes through 0 is small
// there.
CandidateRun fewest_steps(const std::vector<CandidateRun>& refinements, double accuracy, int unit, bool scan,
                          const std::function<CandidateRun(int steps)>& attempt);

// Bisects for a run within the accuracy between two runs whose errors at the end have opposite signs. nullopt
// if no number of steps in between has a small error, or a run in between fails.
std::optional<CandidateRun> at_sign_change(CandidateRun few, CandidateRun many, int unit,
                                           const std::function<CandidateRun(int steps)>& attempt);

// About 1 % more steps, a multiple of `unit`.
int more_steps(int steps, int unit);

}  // namespace fde::bench
