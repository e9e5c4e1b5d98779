// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/problem.hpp"

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

// The derivative at a step of a grid from the values at steps around it: d/dt = sum_k weights[k]
// value(steps[k]).
struct DifferentiationRule {
  std::vector<int> steps;
  Vec weights;
};

// Differentiates the polynomial through the five nearest steps, of order 4; of fewer if the grid has fewer.
// At the first steps polynomials do not approximate a value that starts with t^p, p in `powers`; there the
// basis 1, t^p1, t^p2, ... of the smallest powers is used in place of polynomials. Precondition: 1 <= n <=
// grid.steps.
DifferentiationRule differentiation_rule(const Grid& grid, int n, const std::vector<double>& powers);

// The times around t > 0, other than t, at which derivative_at(t, ...) evaluates; increasing, in (0, end].
std::vector<double> derivative_times(double t, double end);

// The derivative at t of a function known at any time up to `end`: by polynomials of degree 4 through values
// at t and at distances d and 4 d. Of d = t/16, t/64, ... it takes the one whose result differs least from
// the next. A small distance reduces the error of the polynomial, also near a start like t^p, but amplifies
// errors of the values. At the end all times are before t.
Vec derivative_at(double t, double end, const std::function<Vec(double)>& values);

}  // namespace fde::bench
