// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace fde::bench {

// What else the machine did while a thread was timed. Quantities that the system does not tell are absent.
struct TimingConditions {
  std::optional<double> load{};       // average number of running tasks in the minute before
  double switches = 0.0;              // number of times that the system took the processor from the thread
  std::optional<double> frequency{};  // of the processor at the end, in Hz
};

// Watches the calling thread from its construction on.
class TimingWatch {
 public:
  TimingWatch();

  // Since the construction. Precondition: called by the same thread.
  [[nodiscard]] TimingConditions conditions() const;

 private:
  std::optional<double> load_;
  double switches_;
};

// The median of the times of a solve, and its confidence interval.
struct MedianInterval {
  double median = 0.0, low = 0.0, high = 0.0;  // seconds
  double confidence = 0.95;                    // probability that the interval contains the true median
};

// The median with an interval from order statistics; for fewer than six times the interval is from the
// minimum to the maximum, which n times on the same side of the true median miss: its confidence is
// 1 - 2^(1-n). Precondition: at least one time.
MedianInterval spread_of(std::vector<double> seconds);

}  // namespace fde::bench
