#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <unsupported/Eigen/AutoDiff>

namespace fde::mechanics {

template <class Scalar, int n>
using Vector = Eigen::Matrix<Scalar, n, 1>;
template <class Scalar, int rows, int columns>
using Table = Eigen::Matrix<Scalar, rows, columns>;

// A number with its derivatives in some directions. Scalar may be such a number itself: second derivatives.
template <class Scalar, int directions>
using Dual = Eigen::AutoDiffScalar<Vector<Scalar, directions>>;

template <class Scalar, int directions>
Dual<Scalar, directions> constant(const Scalar& value) {
  return {value, Vector<Scalar, directions>::Constant(Scalar(0.0))};
}

// x with dx = 1 in one direction.
template <int directions, class Scalar>
Dual<Scalar, directions> variable(const Scalar& x, int direction = 0) {
  auto result = constant<Scalar, directions>(x);
  result.derivatives()[direction] = Scalar(1.0);
  return result;
}

template <int directions, class Scalar, int n>
Vector<Dual<Scalar, directions>, n> constants(const Vector<Scalar, n>& x) {
  Vector<Dual<Scalar, directions>, n> result;
  for (int i = 0; i < n; ++i) result[i] = constant<Scalar, directions>(x[i]);
  return result;
}

// x with d x_i = 1 in direction first + i.
template <int directions, class Scalar, int n>
Vector<Dual<Scalar, directions>, n> variables(const Vector<Scalar, n>& x, int first = 0) {
  Vector<Dual<Scalar, directions>, n> result;
  for (int i = 0; i < n; ++i) result[i] = variable<directions>(x[i], first + i);
  return result;
}

// x that moves with the given velocity in one direction: what depends on it has its rate of change there.
template <int directions, class Scalar, int n>
Vector<Dual<Scalar, directions>, n> moving(const Vector<Scalar, n>& x, const Vector<Scalar, n>& velocity,
                                           int direction = 0) {
  auto result = constants<directions>(x);
  for (int i = 0; i < n; ++i) result[i].derivatives()[direction] = velocity[i];
  return result;
}

// 0 in every coordinate, and in all its derivatives.
template <class Scalar, int n>
Vector<Scalar, n> zeros() {
  return Vector<Scalar, n>::Constant(Scalar(0.0));
}

}  // namespace fde::mechanics
