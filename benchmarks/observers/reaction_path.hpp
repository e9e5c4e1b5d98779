#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/grid.hpp"
#include "scenes/scene.hpp"

namespace fde {

// These times of a run up to `end` and those beside them whose columns tell the reactions there, in
// increasing order. No grid: the times are a scheme's own.
std::vector<double> with_times_beside(const Reactions& reactions, const std::optional<Grid>& grid,
                                      std::vector<double> times, double end);

// The reactions along a path that was solved for at such times. With memory they need the rates of columns.
class ReactionPath {
 public:
  // The scene and the path must live as long.
  ReactionPath(const Scene& scene, const std::optional<Grid>& grid, const Trajectory& path);

  // Those of the scene.
  [[nodiscard]] std::vector<std::string> names() const;
  // The multipliers and their power in column c of the path, whose columns are given. NaN where a multiplier
  // is unbounded.
  [[nodiscard]] Vec at(Eigen::Index c, In columns) const;

 private:
  [[nodiscard]] std::optional<Vec> rates(double t) const;
  [[nodiscard]] Vec rated_at(double t) const;

  const Scene& scene_;
  std::optional<Grid> grid_;
  const Trajectory& path_;
};

}  // namespace fde
