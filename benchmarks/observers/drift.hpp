// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/observers/course.hpp"
#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/problem/grid.hpp"

namespace fde::bench {

// The largest value up to t as a function of t, for charts: at eight times per factor of 2, from end/1024 on,
// to three digits. A time at which no value was positive is left out.
class RunningMaximum {
 public:
  explicit RunningMaximum(double end);

  // Times must increase.
  void observe(double t, double value);

  [[nodiscard]] const Course& course() const { return course_; }

 private:
  void add(double t, double value);

  double next_, largest_ = 0.0;
  Course course_{};
};

// The drift of a run from its constraints as a function of time.
class DriftGrowth {
 public:
  explicit DriftGrowth(double end) : next_(end / 8.0) {}

  // Adds |f|_inf; times must increase.
  void observe(double t, double drift);

  // max |f|, in the unit of f; not finite if a drift was not.
  [[nodiscard]] double largest() const { return largest_; }

  // p if the maximum drift up to t grows like t^p: the least-squares slope of its logarithm against log t,
  // from end/8 to end with at most 16 samples an octave. 0: the drift is bounded. nullopt if the drift is
  // rounding error in the sense of fit_rate.
  [[nodiscard]] std::optional<double> growth() const;

 private:
  double largest_ = 0.0, next_;
  std::vector<ErrorSample> course_{};  // with h = time
};

// The drift of one run: its size, in the unit of f, its growth, and the largest drift up to t.
struct Drift {
  double largest;
  std::optional<double> growth{};
  Course course{};
};

// Both drifts of a scene with a constraint, accumulated during the solve. The internal drift is |f(t,
// columns)|_inf at every step, with the w of the scheme. The independent drift, on uniform grids, replaces w
// by D^order q computed from the velocities by IndependentMemoryRule; for this purpose the velocities are
// stored.
class DriftObserver {
 public:
  // The scene must outlive this object. `grid` is nullopt for an adaptive step size.
  DriftObserver(const Scene& scene, const std::optional<Grid>& grid);

  // Called after every step, in order, from t = 0 on.
  void observe(double t, In columns);

  // Call both after the last step. The internal drift has a course only if there is no independent drift.
  [[nodiscard]] Drift internal() const;

  // It evaluates the first 16 steps and 256 evenly spaced ones, except t = 0, and for the course eight more
  // per factor of 2 in t. nullopt if the scene has no memory columns, the steps are not those of the grid,
  // the grid is not uniform, or there are too few steps.
  [[nodiscard]] std::optional<Drift> independent() const;

 private:
  [[nodiscard]] bool is_independent() const { return grid_ && step_count_ > grid_->steps; }

  const Scene& scene_;
  std::optional<Grid> grid_;  // nullopt: no independent drift
  DriftGrowth internal_;
  RunningMaximum internal_course_;
  int step_count_ = 0;
  std::vector<int> evaluated_steps_{};
  std::vector<Vec> columns_{};  // columns at these steps
  Matrix velocities_{};         // one row a step, one column a memory column
};

// max_n |E(t_n) - E(0) - int_0^(t_n) power dt - sum_k int_0^(t_n) c_k dx_k|, with x_k the columns
// `differentiated_columns` of the Energy and c_k its `rate_coefficients`, accumulated step by step without
// storing the path. The integrals are those of the parabola through the last three steps, of third order,
// which is higher than the rate of any scheme here. If the c_k are affine in x, the second integral is exact
// at any step size, also at the singular start of a reaction.
class EnergyObserver {
 public:
  // `energy` must outlive this object.
  explicit EnergyObserver(const Energy& energy) : energy_(energy) {}

  // Called after steps 0, 1, 2, ... in order.
  void observe(double t, In columns);

  // nullopt before three steps. Not finite if an energy was not.
  [[nodiscard]] std::optional<double> residual() const;

 private:
  struct Point {
    double t = 0.0, energy = 0.0, power = 0.0;
    Vec rate_coefficients{}, differentiated_columns{};
  };
  [[nodiscard]] Point point_at(double t, In columns) const;
  void compare(const Point& at);

  const Energy& energy_;
  std::array<Point, 3> last_{};
  int step_count_ = 0;
  double start_ = 0.0, largest_ = 0.0;
  RunningSums work_{1};
};

}  // namespace fde::bench
