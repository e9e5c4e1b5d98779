#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

// On which side of each of the problem's switches (t, y) is: whether it is positive there.
std::vector<bool> sides(const Problem& problem, double t, In y);

}  // namespace fde
