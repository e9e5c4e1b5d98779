// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseLU>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

using SparseLu = Eigen::SparseLU<SparseMatrix>;

}  // namespace fde

// Compiled once, in sparse_factors.cpp.
extern template class Eigen::SparseLU<fde::SparseMatrix>;
