#pragma once

#include "two_sided/increments.hpp"

namespace fde {

// The result of Newton's method.
struct NewtonEnd {
  Guess guess;
  double residual;  // its norm
  bool converged;
};

// Newton's method with step halving at all times at once, from a start. It has converged where the last
// increment is below tolerance * |y|, or has stopped shrinking below 1e-10 * |y|.
NewtonEnd newton(const AllTimes& equations, Increments& increments, Run& run, double tolerance, Guess start);

}  // namespace fde
