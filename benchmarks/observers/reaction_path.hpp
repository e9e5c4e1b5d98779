// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/grid.hpp"

namespace fde::bench {

// The given times of a run up to `end`, and the times beside them that are needed to compute the reactions
// there, increasing. `grid` is nullopt for an adaptive step size.
std::vector<double> with_neighbour_times(const Reactions& reactions, const std::optional<Grid>& grid,
                                         std::vector<double> times, double end);

// The reactions along a path that contains the times of with_neighbour_times. With memory they need
// derivatives of columns.
class ReactionPath {
 public:
  // `scene` and `path` must outlive this object.
  ReactionPath(const Scene& scene, const std::optional<Grid>& grid, const Trajectory& path);

  // The reaction names of the scene.
  [[nodiscard]] std::vector<std::string> names() const;
  // The multipliers and their power at column c of the path, whose scene columns are given. NaN if a
  // multiplier is unbounded.
  [[nodiscard]] Vec at(Eigen::Index c, In columns) const;

 private:
  [[nodiscard]] std::optional<Vec> rates(double t) const;
  [[nodiscard]] Vec columns_to_differentiate_at(double t) const;

  const Scene& scene_;
  std::optional<Grid> grid_;
  const Trajectory& path_;
};

}  // namespace fde::bench
