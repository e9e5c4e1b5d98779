#include "problem/jumps.hpp"

namespace fde {

std::vector<double> jumps(const Problem& problem) {
  const auto* jumping = problem.rhs.target<JumpingRhs>();
  return jumping == nullptr ? std::vector<double>{} : jumping->jumps;
}

}  // namespace fde
