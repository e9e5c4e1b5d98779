// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// The powers of t in the solution at t = 0 that follow from the orders alone, for a right-hand side smooth in
// t and y: all gamma_i + (sums of orders and integers), and t for orders above 1. For a problem in multi-term
// form they follow from the orders of the terms, with forces that depend on u.
Smoothness generic_smoothness(const Problem& problem);

// The smallest grading exponent with which the scheme has its largest rate in the maximum norm for
// generic_smoothness(problem): the smooth rate over the rate at the start (rates.hpp), rounded up to
// hundredths, at most 10. 1 where the scheme refuses the problem or graded grids, or has no rate, and for
// two-sided problems. It depends on the orders only, not on the solution.
double optimal_grading(const Scheme& scheme, const Problem& problem);

}  // namespace fde
