// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/run.hpp"

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

// The size with which a first step by the rectangle rule meets the tolerance; at least 1e-290 of the end.
double initial_step_size(const Problem& problem, const Tolerance& accuracy, Run& run);

// Whether there are components that start from 0 and, on a first step of this part of the end, none of them
// has to meet the relative tolerance.
bool exempt_from_relative_tolerance(const Problem& problem, In start, double part_of_end);

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
