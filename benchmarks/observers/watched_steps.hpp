#pragma once

#include <vector>

#include "problem/grid.hpp"

namespace fde {

// The steps at which a run of this many is compared with the reference: all of them up to `most`, beyond that
// the first 16 and `most` spread evenly.
constexpr int most_watched = 8192;
std::vector<int> watched_steps(int steps, int most = most_watched);

// Their times.
std::vector<double> watched_times(const Grid& grid, int most = most_watched);

}  // namespace fde
