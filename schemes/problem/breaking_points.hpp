// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The times at which f, or its derivative by t, jumps, increasing: a polynomial resolves f on one side of
// each.
std::vector<double> breaking_points(const Problem& problem);

}  // namespace fde
