#pragma once

#include <variant>

#include "fdebench/schemes/problem/grid.hpp"

namespace fde {

// The tolerance of an adaptive scheme: at each time the estimated error of each component is at most
// relative |y| + absolute.
struct Tolerance {
  double relative, absolute;
};

// The discretisation parameter that a sweep varies: a grid of given times, or a tolerance for an adaptive
// step size.
using Resolution = std::variant<Grid, Tolerance>;

}  // namespace fde
