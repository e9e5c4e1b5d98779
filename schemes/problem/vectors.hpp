#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace fde {

// Vectors and matrices in double, and how functions take them: In is read, Out is written and has its size.
using Vec = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using ComplexMatrix = Eigen::MatrixXcd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using In = const Eigen::Ref<const Vec>&;
using Out = Eigen::Ref<Vec>;
using OutMatrix = Eigen::Ref<Matrix>;

}  // namespace fde
