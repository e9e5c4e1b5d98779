#pragma once

#include <vector>

namespace fde {

// What a solve takes: the median of its times, and between which the median is with 95 % probability.
struct TimeSpread {
  double median = 0.0, low = 0.0, high = 0.0;  // seconds
};

// The median of some times and its interval by their order alone; of less than six from the least to the
// largest.
TimeSpread spread_of(std::vector<double> seconds);

}  // namespace fde
