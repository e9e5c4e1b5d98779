// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// `size`: the largest |y_n| of the last fifth of a run. `growth`: size divided by the largest |y_n| of a
// fifth of the steps that starts at the middle. Both are infinite if the run overflowed.
struct LateGrowth {
  double size, growth;
};

// Solves the problem with `steps` equal steps of this length.
inline LateGrowth late_growth(const Scheme& scheme, Problem problem, double length, int steps) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  problem.end = length * steps;
  const Rows y = scheme.solve(problem, Grid{problem.end, steps}, {}).y;
  if (y.cols() <= steps) return {infinity, infinity};
  const auto size = [&](int begin) { return y.middleCols(begin, steps / 5).cwiseAbs().maxCoeff(); };
  return {size(steps - steps / 5), size(steps - steps / 5) / size(steps / 2)};
}

// Whether a run decays, or grows. Above order 1.8 the decay ends at about 1e-9, by rounding.
inline bool decays(const LateGrowth& x) { return x.size < 1e-6 || (x.size < 1.0 && x.growth < 1.0); }
inline bool grows(const LateGrowth& x) { return x.growth > 1.1; }

}  // namespace fde::bench
