// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/two_sided/newton_increments.hpp"

namespace fde {

// The result of Newton's method.
struct NewtonResult {
  GridFunction guess;
  double residual;  // its norm
  bool converged;
};

// Newton's method with step halving at all times at once, from a start. It has converged where the last
// increment is below tolerance * |y|, or has stopped shrinking below 1e-10 * |y|.
NewtonResult solve_by_newton(const GlobalEquations& equations, NewtonIncrements& increments, Run& run,
                             double tolerance, GridFunction start);

}  // namespace fde
