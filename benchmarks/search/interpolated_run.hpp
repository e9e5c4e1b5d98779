// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/benchmarks/search/configuration.hpp"

namespace fde::bench {

// A run on a grid as a function of time. Between the times t_n = T (n/N)^R each column of the scene is
// interpolated by a cubic in n, the variable in which the grid is uniform, through the four nearest steps.
// Its error is O(N^-4) where the solution is smooth in n, less than the error of any scheme here.
class InterpolatedRun {
 public:
  // Solves the scene; stops after `budget` seconds. Preconditions: steps >= 4, and the scheme accepts the
  // problem on this grid.
  InterpolatedRun(const Scene& scene, const Configuration& configuration, int steps, double budget);

  // Whether the run reached the end time with finite values. Precondition of at().
  [[nodiscard]] bool finished() const { return columns_.cols() > 0; }

  // The columns at a time in [0, T]; at several times one row a column, one column a time.
  [[nodiscard]] Vec at(double t) const;
  [[nodiscard]] Rows at(const std::vector<double>& times) const;

  [[nodiscard]] const Grid& grid() const { return grid_; }

 private:
  Grid grid_;
  Rows columns_{};  // one row a column of the scene, one column a grid time; empty: not finished
};

}  // namespace fde::bench
