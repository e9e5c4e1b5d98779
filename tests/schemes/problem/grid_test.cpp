// SPDX-License-Identifier: MIT
// The times of a grid: its last time is the end, where end * n / n rounds to another double.

#include "fdebench/schemes/problem/grid.hpp"

#include <gtest/gtest.h>

namespace fde::bench {
namespace {

TEST(Grid, EndsAtTheEnd) {
  constexpr int most_steps = 500;
  for (const double grading : {1.0, 2.5}) {
    for (const double end : {0.1, 0.39, 0.7, 1.0 / 3.0, 2e-300, 1e300}) {
      for (int steps = 1; steps <= most_steps; ++steps) {
        const Grid grid{.end = end, .steps = steps, .grading = grading};
        ASSERT_EQ(grid.time(steps), end) << steps << " steps";
        ASSERT_LT(grid.time(steps - 1), end) << steps << " steps";
      }
    }
  }
}

TEST(Grid, HasTimesThatAreDoublesExactly) {
  const Grid grid{.end = 3.0, .steps = 48};
  for (int n = 0; n <= grid.steps; ++n) EXPECT_EQ(grid.time(n), 0.0625 * n);
}

}  // namespace
}  // namespace fde::bench
