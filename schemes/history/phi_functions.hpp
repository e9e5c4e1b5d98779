#pragma once

#include "problem/problem.hpp"

namespace fde {

// phi_k(x) = sum_i (-x)^i / (i + k)!, k = 1, 2, 3: the integrals of exp(-x (1 - w)) w^(k-1) / (k-1)! over w
// in [0, 1]. Sets the first rows of phi, one column a k, and the first entries of decay_minus_one to
// exp(-x) - 1. x does not decrease.
void phi_functions(const Vec& x, Matrix& phi, Vec& decay_minus_one);

}  // namespace fde
