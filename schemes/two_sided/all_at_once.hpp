#pragma once

#include "stepping/run.hpp"

namespace fde {

// Solves a problem under an integral rule for all times at once, by Newton's method with step halving: what a
// two-sided problem needs. Starts from the Taylor parts, with 0 for unknown initial values. Without right
// rows and conditions the result is that of stepping.
//
// The last increment is below tolerance * |y|, or has stopped to shrink below 1e-10 * |y|. Otherwise the
// ending is not_converged, at the first step. Stored are a few values a component and time, the
// Jacobians, and 20 to 200 vectors of right rows, a quarter of a gigabyte where these bounds allow it;
// Cost::history_bytes counts them.
Trajectory solve_all_at_once(const Problem& problem, const Grid& grid, const Options& options,
                             const WeightFamily& family);

}  // namespace fde
