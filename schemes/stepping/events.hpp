#pragma once

#include <functional>

#include "problem/vectors.hpp"

namespace fde {

class Archive;

// In which direction a function passes through 0.
enum class Crossing { either, rising, falling };

// A function along the path whose zeros are looked for: where it changes its sign. A zero at t = 0 is none,
// nor is one that it touches and leaves on the side from which it came. It has no part in the problem.
struct Event {
  std::function<double(double t, In y)> value{};
  Crossing crossing = Crossing::either;  // other zeros are passed over
  bool ends = false;                     // the run, at the first that counts
};

// A zero that was found.
struct Occurrence {
  std::size_t event;  // its number among Options::events
  double t;
  Vec y;

  void state(Archive& archive);
};

}  // namespace fde
