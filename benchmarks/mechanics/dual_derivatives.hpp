// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/dual_matrix.hpp"

namespace fde::bench::mechanics {

// x as a variable: its derivative is 1 in the given direction and 0 in the others.
template <int directions, class Scalar>
Dual<Scalar, directions> variable(const Scalar& x, int direction = 0) {
  Dual<Scalar, directions> result(x);
  result.set_derivative(direction, Scalar(1.0));
  return result;
}

// A vector of dual numbers, of the size of the vector type VectorType.
template <int directions, class VectorType>
using DualVector = Vector<Dual<typename VectorType::Scalar, directions>, VectorType::RowsAtCompileTime>;

// x as constants: all derivatives are 0.
template <int directions, class VectorType>
DualVector<directions, VectorType> constants(const VectorType& x) {
  DualVector<directions, VectorType> result;
  for (int i = 0; i < VectorType::RowsAtCompileTime; ++i)
    result[i] = Dual<typename VectorType::Scalar, directions>(x[i]);
  return result;
}

// x as variables: d x_i = 1 in direction first + i.
template <int directions, class VectorType>
DualVector<directions, VectorType> variables(const VectorType& x, int first = 0) {
  DualVector<directions, VectorType> result;
  for (int i = 0; i < VectorType::RowsAtCompileTime; ++i) result[i] = variable<directions>(x[i], first + i);
  return result;
}

// x with the derivative `velocity` in the given direction, so that functions of it carry their rate of change
// along the velocity.
template <int directions, class VectorType>
DualVector<directions, VectorType> with_velocity(const VectorType& x, const VectorType& velocity,
                                                 int direction = 0) {
  auto result = constants<directions>(x);
  for (int i = 0; i < VectorType::RowsAtCompileTime; ++i) result[i].set_derivative(direction, velocity[i]);
  return result;
}

// The derivatives of x in the directions first, first + 1, ...
template <int size, class Scalar, int directions>
Vector<Scalar, size> derivatives(const Dual<Scalar, directions>& x, int first = 0) {
  Vector<Scalar, size> result;
  for (int i = 0; i < size; ++i) result[i] = x.derivative(first + i);
  return result;
}

// A table of zeros with zero derivatives.
template <class S, int rows, int columns = 1>
Table<S, rows, columns> zeros() {
  Table<S, rows, columns> result;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) result(i, j) = S(0.0);
  }
  return result;
}

// x converted to the scalar type S.
template <class S, int n>
Vector<S, n> converted_to(const Eigen::Matrix<double, n, 1>& x) {
  Vector<S, n> result;
  for (int i = 0; i < n; ++i) result[i] = S(x[i]);
  return result;
}

}  // namespace fde::bench::mechanics
