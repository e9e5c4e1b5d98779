#pragma once

#include <functional>
#include <vector>

#include "problem/problem.hpp"

namespace fde {

// A right-hand side that jumps at some times after 0, increasing, and can be asked for them.
struct JumpingRhs {
  std::function<void(double t, In y, Out f)> rhs;
  std::vector<double> jumps;
  void operator()(double t, In y, Out f) const { rhs(t, y, f); }
};

// The times at which the right-hand side of a problem says that it jumps.
std::vector<double> jumps(const Problem& problem);

}  // namespace fde
