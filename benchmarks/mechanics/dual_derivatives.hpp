#pragma once

#include "fdebench/benchmarks/mechanics/dual_matrix.hpp"

namespace fde::mechanics {

// x as a variable: its derivative is 1 in the given direction and 0 in the others.
template <int directions, class Scalar>
Dual<Scalar, directions> variable(const Scalar& x, int direction = 0) {
  Dual<Scalar, directions> result(x);
  result.set_derivative(direction, Scalar(1.0));
  return result;
}

// A vector of dual numbers, of the size of the vector type Of.
template <int directions, class Of>
using DualVector = Vector<Dual<typename Of::Scalar, directions>, Of::RowsAtCompileTime>;

// x as constants: all derivatives are 0.
template <int directions, class Of>
DualVector<directions, Of> constants(const Of& x) {
  DualVector<directions, Of> result;
  for (int i = 0; i < Of::RowsAtCompileTime; ++i) result[i] = Dual<typename Of::Scalar, directions>(x[i]);
  return result;
}

// x as variables: d x_i = 1 in direction first + i.
template <int directions, class Of>
DualVector<directions, Of> variables(const Of& x, int first = 0) {
  DualVector<directions, Of> result;
  for (int i = 0; i < Of::RowsAtCompileTime; ++i) result[i] = variable<directions>(x[i], first + i);
  return result;
}

// x with the derivative `velocity` in the given direction, so that functions of it carry their rate of change
// along the velocity.
template <int directions, class Of>
DualVector<directions, Of> moving(const Of& x, const Of& velocity, int direction = 0) {
  auto result = constants<directions>(x);
  for (int i = 0; i < Of::RowsAtCompileTime; ++i) result[i].set_derivative(direction, velocity[i]);
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

}  // namespace fde::mechanics
