// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/benchmarks/measures/timing_conditions.hpp"

namespace fde::bench {

// A solve to be timed, and about how many seconds it takes; 0: not known.
struct TimedSolve {
  std::function<void()> solve;
  double expected_seconds = 0.0;
};

// Times several solves in interleaved rounds, each solve once per round, so that other load on the machine
// affects all alike; a solve shorter than 1 ms is repeated within its round. There are at least six rounds,
// three where they take longer than a fifth of a second each. From then on a solve whose interval is above
// that of the quickest is left; the rounds end where one solve is left, where the intervals of all that are
// left are within 2 %, or after `seconds`.
std::vector<MedianInterval> time_interleaved(const std::vector<TimedSolve>& solves, double seconds);

}  // namespace fde::bench
