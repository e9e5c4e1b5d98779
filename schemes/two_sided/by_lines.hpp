#pragma once

#include "problem/grid.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// What is known at the times of one grid, at the times of another one with the same end: by lines between.
Rows by_lines(const Grid& from, const Rows& y, const Grid& to);

}  // namespace fde
