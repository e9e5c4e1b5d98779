#pragma once

#include "checkpoint/archive.hpp"

namespace fde {

// How long the next step is, by the errors of the last two: proportional and integral control (Gustafsson,
// ACM Trans. Math. Softw. 17 (1991)). An error is in units of what is allowed and falls like length^rate.
class StepControl {
 public:
  StepControl(double rate, double length) : rate_(rate), length_(length) {}

  // Of the next attempt.
  [[nodiscard]] double length() const { return length_; }

  // Sets the length after an attempt over a step of this one. Whether the step is taken: its error is at most
  // 1.
  bool judge(double error, double length);

  void state(Archive& archive) { archive(length_, last_, rejected_); }

 private:
  double rate_, length_;
  double last_ = 1.0;      // error of the last step taken
  bool rejected_ = false;  // the last attempt was
};

}  // namespace fde
