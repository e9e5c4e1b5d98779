// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// Throws std::invalid_argument unless the methods for nonlinear references accept this problem: a positive
// finite end, at least one component, left derivatives only, every order in [0, 2] with ceil(order) initial
// values.
void require_supported(const Problem& problem);

}  // namespace fde::reference
