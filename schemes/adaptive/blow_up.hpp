#pragma once

#include "checkpoint/archive.hpp"

namespace fde {

// Detects a component that grows as (t_b - t)^-p near a finite time t_b: the times in which its largest |y|
// doubles shrink by a factor of 2^(-1/p) from one to the next. For exponential growth they are equal.
class BlowUp {
 public:
  explicit BlowUp(In start);

  // Records an accepted step to t.
  void pass(double t, In y);

  // Restarts the count after a jump of f, where components may grow as they do from t = 0.
  void begin_anew() { sooner_.setZero(); }

  // Whether some component has doubled several times in succession, each time faster, the last time within a
  // small part of t.
  [[nodiscard]] bool is_near(double t) const;

  void state(Archive& archive) { archive(largest_, doubled_at_, took_, sooner_); }

 private:
  Vec largest_;            // |y| of each row when it doubled last
  Vec doubled_at_, took_;  // time and duration of that doubling
  Vec sooner_;             // number of successive doublings that were faster than the one before
};

}  // namespace fde
