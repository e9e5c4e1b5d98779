#pragma once

#include "reference.hpp"

namespace fde {

// phi'' + rate2 sin phi = 0, phi(0) = angle, phi'(0) = velocity.
struct FreePendulum {
  double rate2, angle, velocity;
};

// phi and phi' in closed form: swinging, over the top, and on the edge between the two; hanging or, with
// rate2 < 0, standing. In doubles the parameters and the time are those doubles themselves, not the decimals
// that name them: near the top half a unit in the last place grows to a turn. The bound counts how far the
// phase, which grows with time, and the distance from the edge are known.
Reference pendulum_reference(const FreePendulum& pendulum);

}  // namespace fde
