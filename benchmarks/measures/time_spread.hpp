// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fde::bench {

// The median of the times of a solve, and its 95 % confidence interval.
struct MedianInterval {
  double median = 0.0, low = 0.0, high = 0.0;  // seconds
};

// The median with an interval from order statistics; for fewer than six times the interval is from the
// minimum to the maximum. Precondition: at least one time.
MedianInterval spread_of(std::vector<double> seconds);

}  // namespace fde::bench
