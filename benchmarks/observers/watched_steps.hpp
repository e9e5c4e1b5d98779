#pragma once

#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"

namespace fde {

// The steps at which a run of this many is compared with the reference: all of them up to `most`, beyond that
// the first 16 and `most` spread evenly.
constexpr int most_watched = 8192;
std::vector<int> watched_steps(int steps, int most = most_watched);

// Their times.
std::vector<double> watched_times(const Grid& grid, int most = most_watched);

// The times at which all runs that choose their steps are compared with it, on steps and between them: this
// many spread evenly, and four to a power of ten towards the start and towards each jump, where solutions are
// powers of the time since then: at the start down to where t^order, of the smallest order, is rounding.
constexpr int evenly_watched = 2048;
std::vector<double> watched_times(const Problem& problem, int evenly = evenly_watched);

}  // namespace fde
