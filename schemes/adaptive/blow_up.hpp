#pragma once

#include "checkpoint/archive.hpp"

namespace fde {

// Whether a row grows without bound as time nears a finite one, as (t_b - t)^-p does: the times in which its
// largest |y| doubles become shorter by a factor of 2^(-1/p); those of exponential growth are all as long.
class BlowUp {
 public:
  explicit BlowUp(In start);

  // A step to t has been taken.
  void pass(double t, In y);

  // f has jumped there: rows may grow as they do from t = 0.
  void begin_anew() { sooner_.setZero(); }

  // Whether some row has doubled several times, each time sooner, and at last within a small part of t.
  [[nodiscard]] bool is_near(double t) const;

  void state(Archive& archive) { archive(largest_, doubled_at_, took_, sooner_); }

 private:
  Vec largest_;            // |y| of each row when it doubled last
  Vec doubled_at_, took_;  // when that was, and how long it took
  Vec sooner_;             // how many doublings in a row took less time than the one before
};

}  // namespace fde
