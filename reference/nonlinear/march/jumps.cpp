// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/jumps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fde::reference {

double next_discontinuity(const Problem& problem, double after) {
  const auto next = std::ranges::upper_bound(problem.jump_times, after);
  return next == problem.jump_times.end() ? problem.end : std::min(*next, problem.end);
}

bool jumps_at(const Problem& problem, double t) { return std::ranges::binary_search(problem.jump_times, t); }

double last_jump(const Problem& problem, double t) {
  const auto next = std::ranges::upper_bound(problem.jump_times, t);
  return next == problem.jump_times.begin() ? 0.0 : *std::prev(next);
}

bool just_after_jump(const Problem& problem, double from, double to) {
  constexpr double settled = 1e3;
  const double jump = last_jump(problem, from);
  return to - jump <= settled * first_after_jump * jump;
}

Vec node_times(const Problem& problem, double from, double length, In nodes) {
  Vec times = from + length * nodes.array();
  const double stop = next_discontinuity(problem, from);
  if (jumps_at(problem, stop)) times = times.cwiseMin(std::nextafter(stop, 0.0));
  return times;
}

}  // namespace fde::reference
