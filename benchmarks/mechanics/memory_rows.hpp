#pragma once

namespace fde::mechanics {

// The rows that give a formulation w = D^alpha q.
enum class MemoryRows {
  none,       // whole order: no constraint has w, or alpha = 1 and w = v
  below_one,  // D^(1-alpha) w = v
  above_one,  // D^(alpha-1) v = w, D^(2-alpha) w = v'
};

}  // namespace fde::mechanics
