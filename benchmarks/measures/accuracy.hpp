// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// Checks of a result against the reference. Arguments have one row a column of the scene and one column a
// time; |.| is the maximum over the rows. Results are column indices. "Up to the end" requires at least the
// last tenth of the times, because a value may pass through 0 on a shorter interval.

// The first time at which a value is not finite; nullopt: none. No scheme can follow a reference there.
std::optional<Eigen::Index> first_not_finite(const Rows& values);

// The first time from which on, up to the end, the error |values - reference| is at least |reference|, so
// that 0 would be no worse, or the reference is infinite. Errors within rounding of the largest finite
// |reference| do not count. nullopt: the accuracy is not lost.
std::optional<Eigen::Index> accuracy_lost(const Rows& values, const Rows& reference);

// The first time from which on, up to the end, the rounding |values - rounded| is at least a quarter of the
// error: smaller steps do not improve such a result. Both rounding and error are single samples.
std::optional<Eigen::Index> rounding_dominates(const Rows& values, const Rows& rounded,
                                               const Rows& reference);

// max_i (|y_i - reference_i| + bound_i) / |reference_i| at the end; `bound` is the error bound of the
// reference. |reference_i| is at least a thousandth of its maximum over the last tenth of the times, for a
// value that passes through 0. Columns whose reference is 0 over that interval are left out; nullopt if all
// are.
std::optional<double> relative_error(const Rows& values, const Rows& reference, In bound);

}  // namespace fde::bench
