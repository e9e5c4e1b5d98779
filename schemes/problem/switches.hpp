// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// For each of problem.switching_functions whether it is positive at (t, y).
std::vector<bool> switch_signs(const Problem& problem, double t, In y);

}  // namespace fde
