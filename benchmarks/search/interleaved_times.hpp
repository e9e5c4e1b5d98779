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
// affects all alike. Runs for `seconds`, at least three rounds (two where a round takes more than half a
// second), and less where the interval of the quickest is below all others; a solve shorter than 1 ms is
// repeated within its round.
std::vector<MedianInterval> time_interleaved(const std::vector<TimedSolve>& solves, double seconds);

}  // namespace fde::bench
