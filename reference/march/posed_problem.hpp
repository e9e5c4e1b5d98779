#pragma once

#include "problem/problem.hpp"

namespace fde {

// Throws std::invalid_argument unless the methods for nonlinear references can pose this problem: a positive
// end, at least one component, every order in [0, 2] with its initial values.
void require_posed(const Problem& problem);

}  // namespace fde
