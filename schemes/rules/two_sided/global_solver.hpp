// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/rules/two_sided/global_newton.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The solution of the equations to which Newton's method converges from the Taylor part, with 0 for unknown
// initial values. Where it does not converge from there, a nonlinear problem is solved on 64 steps from each
// of initial_guesses(). The result is then the smallest of these solutions, in the mean square over time and
// components, from which Newton's method converges on all times. With Options::all_solutions this search is
// always made, and the further solutions follow. The first result may not have converged.
std::vector<NewtonResult> solve_equations(const GlobalEquations& equations, NewtonIncrements& increments,
                                          Run& run, const Options& options);

// Records that no solution was found, with the residual of Newton's method or because the budget is spent.
Trajectory without_solution(Run& run, const NewtonResult& end, double first_time);

// Solves a problem by an integral rule at all times at once, by Newton's method with step halving, as
// two-sided problems require. Without right rows and conditions the result is that of stepping.
//
// Newton's method has converged where the last increment is below tolerance * |y|, or has stopped shrinking
// below 1e-10 * |y|. Otherwise the status is not_converged, with Trajectory::residual. The memory is a few
// values a component and time, the Jacobians, and 20 to 200 vectors, a quarter of a gigabyte where these
// bounds allow it (Cost::history_bytes).
Trajectory solve_globally(const Problem& problem, const Grid& grid, const Options& options,
                          const WeightFamily& family);

}  // namespace fde
