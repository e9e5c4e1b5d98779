// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

namespace fde::reference {

// The load coefficient * (t - start_time)^power for t >= start_time, power > -1; with over_gamma divided by
// Gamma(power + 1). Power 0 is a constant; a second load with the opposite sign switches it off.
struct Load {
  double coefficient;
  double power = 0.0;
  double start_time = 0.0;
  bool over_gamma = false;
};

// The error message for an invalid load; nullopt for a valid one.
inline std::optional<const char*> validation_error(const Load& load) {
  if (!std::isfinite(load.coefficient)) return "loads have to be finite";
  if (!(load.power > -1.0 && std::isfinite(load.power))) return "powers of loads have to be above -1";
  if (!(load.start_time >= 0.0 && std::isfinite(load.start_time)))
    return "loads have to start at a time from 0 on";
  return std::nullopt;
}

}  // namespace fde::reference
