#pragma once

#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"

namespace fde {

// The steps at which a run of this many steps is compared with the reference: all if there are at most
// `most`, otherwise the first 16 and `most` evenly spaced ones.
constexpr int most_watched = 8192;
std::vector<int> watched_steps(int steps, int most = most_watched);

// Their times.
std::vector<double> watched_times(const Grid& grid, int most = most_watched);

// The times at which runs with an adaptive step size are compared with the reference, at steps or between
// them: `evenly` evenly spaced times, and four a decade towards the start and towards each jump, where
// solutions are powers of the time since then. At the start the smallest is that where t^order, with the
// smallest order, is rounding error.
constexpr int evenly_watched = 2048;
std::vector<double> watched_times(const Problem& problem, int evenly = evenly_watched);

}  // namespace fde
