#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepping/run.hpp"

namespace fde {

// The product trapezoidal rule, stepped, of problems with multipliers too (problem/multipliers.hpp).
//
// Of a multiplier's values at the times of the grid the rule only sees means. In q' = v, v' = a + R^T lambda,
// 0 = g(t, q, v) these are R_(n-1)^T lambda_(n-1) + R_n^T lambda_n: what lambda_(n-1) is off by comes back in
// lambda_n with the other sign, for ever. It is off from the start where lambda(0) is not known, and by about
// h_1^-alpha where lambda ~ t^-alpha has no value there. Where R turns, v hears of it: v is off by about h^2
// h_1^-alpha, which on graded grids need not be small.
//
// So a multiplier is constant on each step: lambda_n on that to t_n. There f is the linear function between
//   f(t_(n-1), y_(n-1), lambda_n)  and  f(t_n, y_n, lambda_n),
// with jumps between the steps, and it is integrated exactly. No lambda(0) has a part in it, and no lambda
// depends on the one before. At order 1 the step adds h (R_(n-1) + R_n)^T lambda_n / 2, as in symmetric
// projection (Hairer, BIT 40 (2000)).
//
// A trajectory has the multipliers at t_n, continued from the middles of the last two steps; at the first
// step its constant.
Trajectory step_trapezoidal(const Problem& problem, const Grid& grid, const Options& options);

// Why the rule does not serve, as half a sentence: a multiplier drives a row of order above 1; between it and
// its constraint more than one order is integrated (index above 2), so that what the rows between are off by
// alternates in the same way; or the problem is two-sided. nullopt: it serves, or there is no multiplier.
std::optional<std::string> refusal_of_multipliers(const Problem& problem);

}  // namespace fde
