// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "support/testing.hpp"

namespace fde::bench {

// Tests of a scheme by its own runs, of problems that it takes.
class SchemeTest : public testing::TestWithParam<const Scheme*> {
 protected:
  static Trajectory run(const Problem& problem, const Grid& grid, const Options& options = {}) {
    EXPECT_EQ(unsupported_reason(*GetParam(), problem, grid), std::nullopt);
    return GetParam()->solve(problem, grid, options);
  }
  static Trajectory run(const Problem& problem, int steps, const Options& options = {}) {
    return run(problem, {problem.end, steps}, options);
  }

  // The values of a run that finishes.
  static Rows values(const Problem& problem, const Grid& grid, const Options& options = {}) {
    const auto path = run(problem, grid, options);
    EXPECT_EQ(path.status, SolveStatus::finished) << path.last_time;
    return path.y;
  }
};

}  // namespace fde::bench
