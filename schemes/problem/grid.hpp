#pragma once

#include <cmath>

namespace fde {

// The times t_n = end (n / steps)^grading, n = 0 ... steps. Grading 1 is the uniform grid; larger values
// gather the times near 0. Always computed from n: no sum of steps, so no accumulated rounding.
struct Grid {
  double end = 1.0;
  int steps = 1;
  double grading = 1.0;

  [[nodiscard]] bool uniform() const { return grading == 1.0; }
  [[nodiscard]] double step() const { return end / steps; }  // h of the uniform grid
  [[nodiscard]] double time(int n) const {
    if (n == steps) return end;
    return uniform() ? n * step() : end * std::pow(static_cast<double>(n) / steps, grading);
  }
};

}  // namespace fde
