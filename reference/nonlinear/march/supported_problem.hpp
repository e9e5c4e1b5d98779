#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// Throws std::invalid_argument unless the methods for nonlinear references accept this problem: a positive
// finite end, at least one component, left derivatives only, every order in [0, 2] with ceil(order) initial
// values.
void require_posed(const Problem& problem);

}  // namespace fde
