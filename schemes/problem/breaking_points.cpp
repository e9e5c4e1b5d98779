// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/breaking_points.hpp"

#include <algorithm>
#include <iterator>

namespace fde {

std::vector<double> breaking_points(const Problem& problem) {
  std::vector<double> times;
  std::ranges::set_union(problem.jump_times, problem.kink_times, std::back_inserter(times));
  return times;
}

}  // namespace fde
