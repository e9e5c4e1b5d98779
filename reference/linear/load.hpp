// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::reference {

// The load coefficient * (t - start_time)^power for t >= start_time, power > -1; with over_gamma divided by
// Gamma(power + 1). Power 0 is a constant; a second load with the opposite sign switches it off.
template <class Number>
struct LoadOf {
  Number coefficient;
  Number power{0};
  Number start_time{0};
  bool over_gamma = false;
};
using Load = LoadOf<double>;  // doubles are taken as their shortest decimals

inline LoadOf<Rational> exact(const Load& load) {
  return {shortest_decimal(load.coefficient), shortest_decimal(load.power), shortest_decimal(load.start_time),
          load.over_gamma};
}

// The error message for an invalid load; nullopt for a valid one.
inline std::optional<const char*> validation_error(const Load& load) {
  if (!std::isfinite(load.coefficient)) return "loads have to be finite";
  if (!(load.power > -1.0 && std::isfinite(load.power))) return "powers of loads have to be above -1";
  if (!(load.start_time >= 0.0 && std::isfinite(load.start_time)))
    return "loads have to start at a time from 0 on";
  return std::nullopt;
}

}  // namespace fde::reference
