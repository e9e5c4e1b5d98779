// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// These times where the grid has them, otherwise those of the grid on both sides; in increasing order.
std::vector<double> grid_times_at(const Grid& grid, const std::vector<double>& times);

// y of a run that stored the grid times at t, interpolated between them.
Vec stored_at(const Trajectory& path, double t);

// The last and some times before it, in the last quarter of the steps.
std::vector<double> late_times(const Grid& grid);

// The start and three times spread over the steps.
std::vector<double> spread_times(const Grid& grid);

// The last four times, or as many as there are.
std::vector<double> last_times(const Grid& grid);

}  // namespace fde
