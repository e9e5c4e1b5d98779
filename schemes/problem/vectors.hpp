// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace fde {

// Vectors and matrices of doubles, and parameter types of functions: In is read; Out and OutMatrix are
// written and already have their size.
using Vec = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using ComplexMatrix = Eigen::MatrixXcd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using In = const Eigen::Ref<const Vec>&;
using Out = Eigen::Ref<Vec>;
using OutMatrix = Eigen::Ref<Matrix>;

}  // namespace fde
