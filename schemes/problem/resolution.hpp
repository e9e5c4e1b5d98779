#pragma once

#include <variant>

#include "problem/grid.hpp"

namespace fde {

// The error that a scheme may make, of each component at each time: at most relative |y| + absolute, as far
// as it can tell.
struct Accuracy {
  double relative, absolute;
};

// How finely a problem is solved, which is what a sweep varies: at the times of a grid, or as an accuracy
// needs.
using Resolution = std::variant<Grid, Accuracy>;

}  // namespace fde
