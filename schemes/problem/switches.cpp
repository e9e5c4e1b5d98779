// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/switches.hpp"

namespace fde {

std::vector<bool> switch_signs(const Problem& problem, double t, In y) {
  std::vector<bool> positive;
  for (const auto& one : problem.switching_functions) positive.push_back(one(t, y) > 0.0);
  return positive;
}

}  // namespace fde
