#pragma once

#include "stepping/run.hpp"

namespace fde {

// Solves a problem under an integral rule for all times at once, by Newton's method with step halving: what a
// two-sided problem needs. Without right rows and conditions the result is that of stepping.
//
// The first start is the Taylor parts, with 0 for unknown initial values. A nonlinear problem for which it
// does not converge is solved on 64 steps from each of other_starts(); the smallest solution there, in the
// mean square over time and components, that leads to one on the whole grid is the result. A problem may have
// others: with Options::all_solutions the search is made in any case, and the next ones are
// Trajectory::others.
//
// The last increment is below tolerance * |y|, or has stopped to shrink below 1e-10 * |y|. Otherwise the
// ending is not_converged, with Trajectory::residual. Stored are a few values a component and time, the
// Jacobians, and 20 to 200 vectors, a quarter of a gigabyte where these bounds allow it;
// Cost::history_bytes counts them.
Trajectory solve_all_at_once(const Problem& problem, const Grid& grid, const Options& options,
                             const WeightFamily& family);

}  // namespace fde
