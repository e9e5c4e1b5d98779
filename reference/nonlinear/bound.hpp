#pragma once

#include <vector>

#include "collocation/march.hpp"
#include "diffusive/march.hpp"

namespace fde {

// An estimate of the error of a solution on each of its panels: twice the larger of its differences to
// another resolution and to a second method, with an allowance for the rounding of f, which all three share.
// Errors change sign, so differences count over the last decade of time, and of
// the time since a jump; the second method's, as errors of
// phase, in proportion to how fast the solution changes.
std::vector<Vec> error_estimates(const Problem& problem, const PiecewiseSolution& solution,
                                 const PiecewiseSolution& other, const DiffusiveSolution& second);

}  // namespace fde
