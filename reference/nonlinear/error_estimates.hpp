// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/nonlinear/collocation/piecewise_solution.hpp"
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"

namespace fde::reference {

// An estimate of the error of a solution on each of its panels: twice the larger of its differences from
// another resolution and from a second method, plus an allowance for the rounding of f, which all three
// share. As errors change sign, the largest difference over the last decade of time, and of the time since a
// jump, counts; differences from the second method on earlier panels, as errors of phase, count in proportion
// to the rate of change of the solution.
std::vector<Vec> error_estimates(const Problem& problem, const PiecewiseSolution& solution,
                                 const PiecewiseSolution& other, const DiffusiveSolution& second);

}  // namespace fde::reference
