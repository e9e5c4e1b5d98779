// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/benchmarks/measures/time_spread.hpp"

namespace fde::bench {

// Times several solves in interleaved rounds, each solve once per round, so that other load on the machine
// affects all alike. Runs for `seconds` and at least three rounds; a solve shorter than 1 ms is repeated
// within its round.
std::vector<MedianInterval> time_interleaved(const std::vector<std::function<void()>>& solves,
                                             double seconds);

}  // namespace fde::bench
