#pragma once

#include <algorithm>
#include <cmath>

namespace fde {

// The times t_n = end (n / steps)^grading, n = 0 ... steps. Grading 1 is the uniform grid; larger values
// gather the times near 0. Always computed from n, and not as n h: a time that is a double, such as that of a
// jump, is met exactly.
struct Grid {
  double end = 1.0;
  int steps = 1;
  double grading = 1.0;

  [[nodiscard]] bool uniform() const { return grading == 1.0; }
  [[nodiscard]] double time(int n) const {
    return uniform() ? end * n / steps : end * std::pow(static_cast<double>(n) / steps, grading);
  }
  // t_n - t_(n-1), n >= 1; on a uniform grid the same number for all n. Does not shrink with n, up to
  // rounding.
  [[nodiscard]] double step(int n = 1) const { return step(time(n - 1), time(n)); }
  // The same from the two times.
  [[nodiscard]] double step(double before, double t) const { return uniform() ? end / steps : t - before; }
  // The n whose t_n is t, or about the nearest, 0 <= t <= end.
  [[nodiscard]] int number(double t) const {
    return std::clamp(static_cast<int>(std::lround(steps * std::pow(t / end, 1.0 / grading))), 0, steps);
  }
};

}  // namespace fde
