#pragma once

#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"

namespace fde {

// The rate of change at a step of a grid from the values at steps around it: d/dt = sum_k weights[k]
// value(steps[k]).
struct LocalRate {
  std::vector<int> steps;
  Vec weights;
};

// That of the polynomial through the five nearest steps, of order 4; of fewer where there are no more. Among
// the first steps no polynomial follows a value that leaves its start with t^p, p of these powers: there it
// is the rate of the sum 1, t^p1, t^p2, ... of the smallest powers through the same values. Needs 1 <= n <=
// grid.steps.
LocalRate local_rate(const Grid& grid, int n, const std::vector<double>& powers);

}  // namespace fde
