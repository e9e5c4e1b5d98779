#pragma once

#include <functional>
#include <vector>

#include "measures/time_spread.hpp"

namespace fde {

// Times solves against each other: each once a round, so that what slows the machine slows all alike, for
// this many seconds, but in three rounds at least. A solve that is too short for the clock is repeated within
// its round.
std::vector<TimeSpread> time_interleaved(const std::vector<std::function<void()>>& solves, double seconds);

}  // namespace fde
