// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Makes `matrix` one of zeros of this size, in large pages as allocate() does. The threads of RowThreads
// share its entries: the first access to memory takes as long as many steps.
void make_zero(Matrix& matrix, Eigen::Index rows, Eigen::Index columns);

}  // namespace fde
