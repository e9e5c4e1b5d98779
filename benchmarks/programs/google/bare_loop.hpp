// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fde::bench {

// c += a b for column-major a (32 x inner), b (inner x columns), c (32 x columns). A plain loop, vectorised
// by the compiler for the widest vectors of the machine: the baseline for the history's kernels.
void bare_multiply_add(Eigen::Index inner, Eigen::Index columns, const double* a, const double* b, double* c);

}  // namespace fde::bench
