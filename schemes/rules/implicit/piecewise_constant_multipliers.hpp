// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The product trapezoidal rule on a grid, also for problems with multipliers (problem/multipliers.hpp).
//
// The rule contains a multiplier only in means over neighbouring times of the grid. In q' = v, v' = a + R^T
// lambda, 0 = g(t, q, v) these are R_(n-1)^T lambda_(n-1) + R_n^T lambda_n: an error of lambda_(n-1) returns
// in lambda_n with the opposite sign, and never decays. There is an error from the start where lambda(0) is
// not known, and one of about h_1^-alpha where lambda ~ t^-alpha has no value there. Where R rotates, this
// error enters v: the error of v is about h^2 h_1^-alpha, which on graded grids need not be small.
//
// Therefore a multiplier is constant on each step: lambda_n on the step to t_n. On this step f is the linear
// function between
//   f(t_(n-1), y_(n-1), lambda_n)  and  f(t_n, y_n, lambda_n),
// with jumps between the steps, and it is integrated exactly. lambda(0) does not occur, and no lambda depends
// on the one before. At order 1 the step adds h (R_(n-1) + R_n)^T lambda_n / 2, as in symmetric projection
// (Hairer, BIT 40 (2000)).
//
// In the trajectory the multipliers at t_n are extrapolated from the middles of the last two steps; at the
// first step its constant is returned.
Trajectory solve_product_trapezoidal(const Problem& problem, const Grid& grid, const Options& options);

// Why the rule is not applicable, as half a sentence: a multiplier enters a row of order above 1; more than
// one order is integrated between a multiplier and its constraint (index above 2), so that the errors of the
// rows between alternate in the same way; or the problem is two-sided. nullopt: it is applicable, or there is
// no multiplier.
std::optional<std::string> unsupported_multipliers_reason(const Problem& problem);

}  // namespace fde
