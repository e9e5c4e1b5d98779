// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// Step size control by the errors of the last two steps: proportional and integral (Gustafsson, ACM Trans.
// Math. Softw. 17 (1991)). Errors are in units of the tolerance and fall like length^rate.
class PiController {
 public:
  PiController(double rate, double length) : rate_(rate), length_(length) {}

  // Size of the next attempt.
  [[nodiscard]] double length() const { return length_; }

  // Sets the size of the next attempt from the error of an attempt of this length. Returns whether that step
  // is accepted: its error is at most 1.
  bool update(double error, double length);

  void state(Archive& archive) { archive(length_, last_error_, rejected_); }

 private:
  double rate_, length_;
  double last_error_ = 1.0;  // error of the last accepted step
  bool rejected_ = false;    // whether the last attempt was rejected
};

}  // namespace fde
