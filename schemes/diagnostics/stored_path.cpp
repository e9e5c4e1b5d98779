// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/stored_path.hpp"

#include <algorithm>
#include <cmath>

namespace fde {
namespace {

constexpr double rounding = 1e-12;

std::vector<double> increasing(std::vector<double> times) {
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// The time of the step that has gone this part of all steps, after the first.
double time_of_part(const Grid& grid, double part) {
  return grid.time(std::max(1, static_cast<int>(std::lround(part * grid.steps))));
}

}  // namespace

std::vector<double> grid_times_at(const Grid& grid, const std::vector<double>& times) {
  std::vector<double> found;
  for (const double t : times) {
    const int nearest = grid.nearest_index(t);
    found.push_back(grid.time(nearest));
    if (std::abs(grid.time(nearest) - t) <= rounding * t) continue;
    const int beside = grid.time(nearest) < t ? nearest + 1 : nearest - 1;
    found.push_back(grid.time(std::clamp(beside, 0, grid.steps)));
  }
  return increasing(found);
}

Vec stored_at(const Trajectory& path, double t) {
  const auto above = std::ranges::lower_bound(path.times, t * (1.0 - rounding));
  const auto column =
      std::min(static_cast<Eigen::Index>(above - path.times.begin()), path.y.cols() - Eigen::Index{1});
  const double end = path.time(column);
  if (column == 0 || end <= t * (1.0 + rounding)) return path.y.col(column);
  const double begin = path.time(column - 1), share = (t - begin) / (end - begin);
  return (1.0 - share) * path.y.col(column - 1) + share * path.y.col(column);
}

std::vector<double> late_times(const Grid& grid) {
  std::vector<double> times;
  for (const double part : {0.75, 0.8125, 0.875, 0.9375, 1.0}) times.push_back(time_of_part(grid, part));
  return increasing(times);
}

std::vector<double> spread_times(const Grid& grid) {
  return increasing({0.0, time_of_part(grid, 0.25), time_of_part(grid, 0.5), grid.end});
}

std::vector<double> last_times(const Grid& grid) {
  std::vector<double> times;
  for (int n = std::max(0, grid.steps - 3); n <= grid.steps; ++n) times.push_back(grid.time(n));
  return times;
}

}  // namespace fde
