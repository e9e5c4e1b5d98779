#include "fdebench/schemes/problem/switches.hpp"

namespace fde {

std::vector<bool> sides(const Problem& problem, double t, In y) {
  std::vector<bool> positive;
  for (const auto& one : problem.switches) positive.push_back(one(t, y) > 0.0);
  return positive;
}

}  // namespace fde
