// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// Interpolates y linearly from the times of one grid to the times of another, one column a time.
// Precondition: the grids have the same end.
Rows interpolate_linearly(const Grid& from, const Rows& y, const Grid& to);

}  // namespace fde
