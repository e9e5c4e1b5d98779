#pragma once

#include <optional>
#include <vector>

#include "observers/rate.hpp"
#include "problem/grid.hpp"
#include "scenes/scene.hpp"

namespace fde {

// How far a run strays from its constraints in the course of time.
class DriftCourse {
 public:
  explicit DriftCourse(double end) : next_(end / 8.0) {}

  // Takes |f|_inf at increasing times.
  void observe(double t, double drift);

  // max |f|, in the unit of f; not finite where a drift was not.
  [[nodiscard]] double largest() const { return largest_; }

  // p where the largest drift up to t grows like t^p: the slope of its logarithm against that of t by least
  // squares, from end/8 to end at 16 times an octave, where these are steps. 0: it stays bounded. Nothing
  // where the drift is at rounding, in the sense of fit_rate.
  [[nodiscard]] std::optional<double> growth() const;

 private:
  double largest_ = 0.0, next_;
  std::vector<ErrorAt> course_{};  // h: a time
};

// The drift of one run: its size, in the unit of f, and its growth.
struct Drift {
  double largest;
  std::optional<double> growth{};
};

// Both drifts of a scene with a constraint, while it is solved. The internal one is |f(t, columns)|_inf at
// every step, with the scheme's own w. The independent one, on uniform grids, takes in its place D^order q of
// the computed velocities by IndependentMemory; for this the velocities are kept.
class DriftObserver {
 public:
  // The scene must live as long. No grid: the times are a scheme's own.
  DriftObserver(const Scene& scene, const std::optional<Grid>& grid);

  // Takes the steps in order, from t = 0 on.
  void observe(double t, In columns);

  [[nodiscard]] Drift internal() const;

  // To be asked after the last step; looks at the first 16 steps and 256 spread evenly, t = 0 apart.
  // Nothing where the scene has no memories, the steps are not those of the grid, or it is not uniform or has
  // too few of them.
  [[nodiscard]] std::optional<Drift> independent() const;

 private:
  const Scene& scene_;
  std::optional<Grid> grid_;  // empty: no independent drift
  DriftCourse internal_;
  int seen_ = 0;
  std::vector<int> looked_at_{};
  std::vector<Vec> columns_{};  // at these
  Matrix velocities_{};         // a row a step, a column a memory
};

}  // namespace fde
