// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace fde {

// The times t_n = end (n / steps)^grading, n = 0 ... steps; the exponent `grading` is at least 1. Grading 1
// is the uniform grid; larger values concentrate the times near 0. The last time is `end` exactly: no
// solution is known after it. The others are computed from n and not as n h: a grid time that is a double,
// such as the time of a jump, is exact.
struct Grid {
  double end = 1.0;
  int steps = 1;
  double grading = 1.0;

  [[nodiscard]] bool uniform() const { return grading == 1.0; }
  [[nodiscard]] double time(int n) const {
    if (n == steps) return end;
    return uniform() ? end * n / steps : end * std::pow(static_cast<double>(n) / steps, grading);
  }
  // The step size t_n - t_(n-1), n >= 1; on a uniform grid the same double for all n. It does not decrease
  // with n, up to rounding.
  [[nodiscard]] double step(int n = 1) const { return step(time(n - 1), time(n)); }
  // The step size from t_(n-1) = before and t_n = t.
  [[nodiscard]] double step(double before, double t) const { return uniform() ? end / steps : t - before; }
  // The n of the grid time t, otherwise of a grid time near t. Precondition: 0 <= t <= end.
  [[nodiscard]] int nearest_index(double t) const {
    return std::clamp(static_cast<int>(std::lround(steps * std::pow(t / end, 1.0 / grading))), 0, steps);
  }
};

}  // namespace fde
