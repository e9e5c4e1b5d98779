// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <variant>

#include "fdebench/schemes/problem/grid.hpp"

namespace fde {

// The tolerance of an adaptive scheme: the estimated error of each component is at most rtol |y| + atol at
// each time.
struct Tolerance {
  double rtol, atol;

  auto operator<=>(const Tolerance&) const = default;
};

// The discretisation parameter that a sweep varies: a grid of given times, or a tolerance for an adaptive
// step size.
using Resolution = std::variant<Grid, Tolerance>;

}  // namespace fde
