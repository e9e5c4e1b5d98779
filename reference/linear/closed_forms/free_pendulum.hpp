// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/reference.hpp"

namespace fde::reference {

// phi'' + rate2 sin phi = 0, phi(0) = angle, phi'(0) = velocity.
struct FreePendulum {
  double rate2, angle, velocity;
};

// phi and phi' in closed form: libration, rotation and the separatrix; rate2 < 0 is the inverted pendulum.
// at() takes the parameters and the time as exact doubles, not as their shortest decimals, since near the top
// half a unit in the last place grows to a full turn. The bound includes the errors of the phase, which grow
// with time, and of the distance from the separatrix.
Reference pendulum_reference(const FreePendulum& pendulum);

}  // namespace fde::reference
