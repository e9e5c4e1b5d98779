// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Scheme::solve for problems with conditions at both ends too, unless they have right derivatives: it finds
// the unknown initial values by shooting (shooting.hpp) with runs of the scheme itself, and then solves the
// initial value problem. These depend smoothly on y(end), so that the error has the rate of an initial value
// problem at fixed times. Only the last run is observed and locates events; costs and Options::budget are
// those of all runs. The trajectory of a failure contains y(0) alone if Newton's method does not converge, or
// if another resolution, twice as many steps or a 16 times larger tolerance, gives other values
// (are_determined): SolveStatus::undetermined. If the first run does not reach the end, it is its trajectory.
Solve with_conditions(Solve solve);

}  // namespace fde
