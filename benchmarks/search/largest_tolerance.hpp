// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "fdebench/benchmarks/search/candidate_run.hpp"

namespace fde::bench {

// The run with the largest tolerance, to a factor of two, whose error is within the accuracy `wanted`, for a
// scheme whose error is about its tolerance; `attempt` makes a run. The first tolerance is `wanted`; it is
// then multiplied or divided by 10 (down to wanted / 1e6) until the result changes, and bisected. nullopt if
// no run is within the accuracy.
std::optional<CandidateRun> largest_tolerance(double wanted,
                                              const std::function<CandidateRun(double requested)>& attempt);

}  // namespace fde::bench
