#pragma once

#include "stepping/scheme.hpp"

namespace fde {

// How solutions of a problem start whose right-hand side is smooth in t and y, by its orders alone: every
// power gamma_i + (sums of orders and whole numbers), and the slopes at t = 0 of orders above 1. Of a problem
// that is told as equations: what their terms and the forces, taken to read u, make of it.
Smoothness smoothness_of_orders(const Problem& problem);

// The smallest grading of a grid with which the scheme has its largest rate in the maximum norm for such a
// solution: the smooth rate over what the start costs (rates.hpp), rounded up to hundredths. 1 where the
// scheme refuses the problem or all graded grids, or has no rate; at most 10, whose first step is short
// enough. It takes nothing but the orders: not what is known of the solution.
double optimal_grading(const Scheme& scheme, const Problem& problem);

}  // namespace fde
