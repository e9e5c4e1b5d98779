#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// For each of problem.switches whether it is positive at (t, y).
std::vector<bool> sides(const Problem& problem, double t, In y);

}  // namespace fde
