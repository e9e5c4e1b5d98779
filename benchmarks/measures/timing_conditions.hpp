// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

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

}  // namespace fde::bench
