// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Solves a problem with right derivatives by collocation on panels, at all times at once (solve_equations()).
// The panels begin as two between any two breaking points of f, and are divided until on each the last
// Legendre coefficients of f and of y are below the tolerance: in halves, or, next to both ends and to
// breaking points, where the solution behaves like a power of the distance, towards them. The times of the
// result are the edges of the panels.
//
// The status is not_converged where Newton's method does not converge, step_too_small where a panel that is
// not divided further is not accurate, with its time.
Trajectory solve_on_panels(const Problem& problem, const Tolerance& accuracy, const Options& options);

}  // namespace fde
