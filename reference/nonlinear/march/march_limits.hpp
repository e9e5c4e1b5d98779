// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// Throws std::invalid_argument unless the methods for nonlinear references accept this problem: a positive
// finite end, at least one component, left derivatives only, every order in [0, 2] with ceil(order) initial
// values.
void require_supported(const Problem& problem);

// The solution leaves the domain of its problem before the requested time.
struct Singularity : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Whether an integration that went from `before` to `now` in `steps` steps, with `steps_left` more allowed,
// will not reach the end: its time has not doubled, as it does while steps grow, and at this pace the end is
// far out of reach.
constexpr bool cannot_reach_end(double before, double now, std::size_t steps, double end,
                                std::size_t steps_left) {
  constexpr double far = 3.0;
  const double pace = (now - before) / static_cast<double>(steps);
  return now < 2.0 * before && end - now > far * pace * static_cast<double>(steps_left);
}

// At the times where f is discontinuous a panel or step ends, and the integration restarts as at t = 0: the
// solution continues with fractional powers of the time since the jump.

// The first jump of f after this time, or the end if that is earlier.
double next_discontinuity(const Problem& problem, double after);

// Whether f jumps at this time.
bool jumps_at(const Problem& problem, double t);

// Adds a time to those at which f jumps.
void add_jump_time(Problem& problem, double t);

// The latest jump at or before this time, or 0.
double last_jump(const Problem& problem, double t);

// The times from + length nodes, 0 < nodes <= 1, of a piece (panel or step). A time at which f jumps is
// replaced by the double before it, where f has its left limit. Precondition: the piece ends at
// next_discontinuity() or before.
Vec node_times(const Problem& problem, double from, double length, In nodes);

// The length of the first piece after a jump, relative to the time of the jump: as short as possible with
// nodes that are different doubles.
inline constexpr double first_after_jump = 1e-11;

// Whether a piece is so soon after a jump that the error of the first piece has not decayed: lengths then
// only double.
bool just_after_jump(const Problem& problem, double from, double to);

}  // namespace fde::reference
