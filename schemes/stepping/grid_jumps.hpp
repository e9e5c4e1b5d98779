// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The grid times after 0 at which the right-hand side of a problem jumps. A rule needs two values of f there.
// Its memory takes the mean of both sides, with which the trapezoidal rule and L1 keep their rates after the
// jump. The value that a step to such a time delivers is computed with f from the left: with the mean it
// would have an error O(h^order).
class GridJumps {
 public:
  // A jump is at a grid time where they agree to 1e-12 relative.
  GridJumps(const Problem& problem, const Grid& grid);

  [[nodiscard]] bool empty() const { return jumps_.empty(); }

  // A time just before t if f jumps at the grid time t, otherwise nullopt.
  [[nodiscard]] std::optional<double> before(double t) const;

  // Calls correct(t), which changes y from its prediction. Where f jumps at t, the result is true, and
  // `delivered` is y corrected before the jump.
  template <class Correct>
  bool correct(double t, Vec& y, Vec& delivered, const Correct& correct) const {
    const auto before = this->before(t);
    if (before) {
      const Vec prediction = y;
      correct(*before);
      delivered = y;
      y = prediction;  // in the same storage: the caller may hold a view of it
    }
    correct(t);
    return before.has_value();
  }

  // The problem with the mean of both sides of f, of its Jacobian and of its equations at these times.
  [[nodiscard]] Problem with_means(const Problem& problem) const;

 private:
  struct Jump {
    double time, before, after;
  };
  [[nodiscard]] const Jump* at(double t) const;

  std::vector<Jump> jumps_;  // by increasing time
};

}  // namespace fde
