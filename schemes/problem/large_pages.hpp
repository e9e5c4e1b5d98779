// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Resizes a matrix, without setting its entries, and asks the system for large pages where the matrix is
// large: the first access to each page of 4 KB may take longer than all later ones, above all on virtual
// machines.
void allocate(Matrix& matrix, Eigen::Index rows, Eigen::Index columns);

}  // namespace fde
