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

}  // namespace fde::reference
