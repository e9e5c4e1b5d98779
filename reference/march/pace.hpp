#pragma once

#include <cstddef>

namespace fde {

// Whether a march that went from one time to another in a number of steps, and has so many left, gets
// nowhere: its time did not double, as it does where steps grow, and at its pace the end is far out of reach.
constexpr bool hopeless(double before, double now, std::size_t steps, double end, std::size_t steps_left) {
  constexpr double far = 3.0;
  const double pace = (now - before) / static_cast<double>(steps);
  return now < 2.0 * before && end - now > far * pace * static_cast<double>(steps_left);
}

}  // namespace fde
