// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"
#include "fdebench/schemes/stepping/zeros_within_step.hpp"

namespace fde {

// Event location: finds the zeros of event functions step by step, from the dense output of the step. The
// function is sampled at the ends of some pieces of the step, which are halved until parabolas resolve it. A
// zero is located between adjacent doubles by algorithm 748 of Alefeld, Potra & Shi (ACM Trans. Math. Softw.
// 21 (1995)); two zeros in one piece are found through the minimum of |value| between them.
class EventLocator {
 public:
  // start = y(0). `events` must outlive this object.
  EventLocator(const std::vector<Event>& events, In start);

  // The zeros on the step from the time of the previous call (at first 0) up to t, by increasing time, up to
  // the first that ends the run. y = y(t).
  std::vector<EventOccurrence> step(double t, In y, const StepInterpolant& within);

  void state(Archive& archive) { archive(time_, values_, left_); }

 private:
  const std::vector<Event>& events_;
  double time_ = 0.0;
  std::vector<double> values_;  // the last nonzero value of each event function
  std::uint64_t left_ = most_samples;
};

}  // namespace fde
