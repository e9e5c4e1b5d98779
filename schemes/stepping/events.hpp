// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

class Archive;

// The direction in which an event function passes through 0.
enum class Crossing { either, rising, falling };

// An event function, located where it changes its sign along the solution. A zero at t = 0 does not count,
// nor does a zero without a change of sign. The function does not influence the solution.
struct Event {
  std::function<double(double t, In y)> value{};
  Crossing crossing = Crossing::either;  // zeros in the other direction do not count
  bool terminal = false;                 // whether the first zero that counts ends the run
};

// A zero of an event function, with y at its time.
struct EventOccurrence {
  std::size_t event;  // index in Options::events
  double t;
  Vec y;

  void state(Archive& archive);
};

}  // namespace fde
