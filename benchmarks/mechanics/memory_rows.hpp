// SPDX-License-Identifier: MIT
#pragma once

namespace fde::bench::mechanics {

// Which equations define w = D^alpha q.
enum class MemoryRows {
  none,       // integer order: no constraint contains w, or alpha = 1 and w = v
  below_one,  // D^(1-alpha) w = v
  above_one,  // D^(alpha-1) v = w, D^(2-alpha) w = v'
};

}  // namespace fde::bench::mechanics
