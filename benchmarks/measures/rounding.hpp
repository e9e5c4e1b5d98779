// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// The problem for u = y / unit. Solving it is the same computation with different rounding: if unit is not a
// power of two, every value, including the initial values, is rounded differently. The difference of unit * u
// and y is a sample of the rounding error of a result.
Problem rescaled_problem(double unit, const Problem& problem);

}  // namespace fde::bench
