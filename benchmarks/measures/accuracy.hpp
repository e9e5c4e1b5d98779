#pragma once

#include <optional>

#include "stepping/trajectory.hpp"

namespace fde {

// What is left of a result beside the reference. Both have one row a column of the scene and one column a
// time of a path; |.| is the largest over the columns of the scene. Times are given as their place among the
// columns. "Up to the end" is over the last tenth of the times at least: where only a shorter stretch is
// concerned, a value may just be passing through 0.

// The first time at which the reference is infinite: no scheme can follow it there. nullopt: there is none.
std::optional<Eigen::Index> first_overflow(const Rows& reference);

// The first time from which on the error |values - reference| is not below the size of the value,
// |reference|, up to the end, or the reference infinite: 0 would be no worse. Errors that are rounding of the
// largest finite |reference| do not count. nullopt: the accuracy is not lost.
std::optional<Eigen::Index> accuracy_lost(const Rows& values, const Rows& reference);

// The first time from which on what rounding does, |values - rounded|, is at least a quarter of the
// error, up to the end: more steps make such a result no better. It is one sample of what rounding does, and
// the error beside it another.
std::optional<Eigen::Index> rounding_dominates(const Rows& values, const Rows& rounded,
                                               const Rows& reference);

// max_i (|y_i - reference_i| + bound_i) / |reference_i| at the end, where the reference is known up to its
// bound. A value that passes through 0 there counts as a thousandth of its size in the last tenth of the
// times. Left out are columns where the reference is 0 all that time; nullopt: it is 0 in all of them.
std::optional<double> relative_error(const Rows& values, const Rows& reference, In bound);

}  // namespace fde
