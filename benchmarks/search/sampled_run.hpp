#pragma once

#include "scenes/scene.hpp"
#include "search/attempt.hpp"

namespace fde {

// A run over a grid as a function of time. Between the times t_n = T (n/N)^R the columns of the scene are
// cubics in n, in which the grid is even: through the four nearest steps, so exact at each of them. Where the
// solution is smooth in n this is off by N^-4, less than any scheme here.
class SampledRun {
 public:
  // Preconditions: four steps at least; the scheme takes the problem over this grid.
  SampledRun(const Scene& scene, const Way& way, int steps, double budget);

  // Whether it came to its end, with finite values: only then it has values.
  [[nodiscard]] bool finished() const { return columns_.cols() > 0; }

  [[nodiscard]] Vec at(double t) const;
  [[nodiscard]] Rows at(const std::vector<double>& times) const;

  [[nodiscard]] const Grid& grid() const { return grid_; }

 private:
  Grid grid_;
  Rows columns_{};  // at all of its times
};

}  // namespace fde
