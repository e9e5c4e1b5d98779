// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// Detects a component that grows as (t_b - t)^-p near a finite time t_b: the times in which its largest |y|
// doubles shrink by a factor of 2^(-1/p) from one to the next. For exponential growth they are equal.
class BlowUpDetector {
 public:
  explicit BlowUpDetector(In start);

  // Records an accepted step to t.
  void accept_step(double t, In y);

  // Restarts the count after a jump of f, where components may grow as they do from t = 0.
  void restart() { faster_doublings_.setZero(); }

  // Whether some component has doubled several times in succession, each time faster, the last time within a
  // small part of t.
  [[nodiscard]] bool is_near(double t) const;

  void state(Archive& archive) { archive(largest_, doubled_at_, doubling_time_, faster_doublings_); }

 private:
  Vec largest_;                     // |y| of each row when it doubled last
  Vec doubled_at_, doubling_time_;  // time and duration of that doubling
  Vec faster_doublings_;            // number of successive doublings that were faster than the one before
};

}  // namespace fde
