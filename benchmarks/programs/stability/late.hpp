#pragma once

#include <limits>

#include "stepping/scheme.hpp"

namespace fde {

// The largest |y| of the last fifth of a run, and that over the largest of as many steps from the middle on;
// both infinite when the run blew up.
struct Late {
  double size, growth;
};

inline Late late(const Scheme& scheme, Problem problem, double length, int steps) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  problem.end = length * steps;
  const Rows y = scheme.solve(problem, Grid{problem.end, steps}, {}).y;
  if (y.cols() <= steps) return {infinity, infinity};
  const auto size = [&](int begin) { return y.middleCols(begin, steps / 5).cwiseAbs().maxCoeff(); };
  return {size(steps - steps / 5), size(steps - steps / 5) / size(steps / 2)};
}

}  // namespace fde
