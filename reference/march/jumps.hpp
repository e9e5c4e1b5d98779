#pragma once

#include "problem/problem.hpp"

namespace fde {

// Where f jumps a march stops and starts anew, as at t = 0: the solution goes on with powers of the time
// since.

// The first jump of f after this time, or the end.
double next_stop(const Problem& problem, double after);

// Whether f jumps at this time.
bool jumps_at(const Problem& problem, double t);

// The latest jump that is not after this time, or 0.
double last_jump(const Problem& problem, double t);

// The times from + length nodes, 0 < nodes <= 1, of a piece that goes on to the next stop at most; for one
// that f jumps at the time just before it, at which f is what it was.
Vec times_of_piece(const Problem& problem, double from, double length, In nodes);

// The length of the first piece behind a jump, relative to its time. As short as its nodes allow, which have
// to be different doubles.
inline constexpr double first_after_jump = 1e-11;

// Whether a piece is so close behind a jump that pieces just double: what the first misses has not died out.
bool just_after_jump(const Problem& problem, double from, double to);

}  // namespace fde
