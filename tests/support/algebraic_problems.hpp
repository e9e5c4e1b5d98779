// SPDX-License-Identifier: MIT
#pragma once

// Problems with algebraic rows, each with the same problem after elimination of these rows by hand.

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

inline Component starting_at_one(double order) {
  return order > 1.0 ? Component{order, {1.0, 0.0}} : Component{order, {1.0}};
}

// D^order y = -y.
inline Problem decay(double order) {
  return {.components = {starting_at_one(order)}, .rhs = [](double, In y, Out f) { f = -y; }, .end = 2.0};
}

// D^order y = -z, 0 = 4 (z - y): the same y.
inline Problem decay_through(double order) {
  return {.components = {{0.0, {1.0}}, starting_at_one(order)},
          .rhs = [](double, In y, Out f) { f << 4.0 * (y[0] - y[1]), -y[0]; },
          .end = 2.0};
}

// a.v + b.w = c0 in the plane, w = D^alpha q, force -k q. For constant a, b the multiplier can be eliminated.
struct AlgebraicPlane {
  double alpha = 0.5;
  Eigen::Vector2d velocity{-0.4, 0.7};
  double end = 2.0;
  Eigen::Vector2d a{1.0, 2.0}, b{0.5, -0.3}, k{1.0, 2.0}, q0{0.8, -0.5};

  [[nodiscard]] Matrix linear_part() const;  // of the problem with the multiplier
  [[nodiscard]] Problem multiplier(double initial_multiplier) const;
  [[nodiscard]] Problem integrated() const;
};

// q' = v, v' = -k q + a lambda, D^(1-alpha) w = v, 0 = a.v + b.w - c0; y = (q, v, w, lambda).
inline Matrix AlgebraicPlane::linear_part() const {
  Matrix linear = Matrix::Zero(7, 7);
  linear.block<2, 2>(0, 2).setIdentity();
  linear.block<2, 2>(2, 0) = -Matrix(k.asDiagonal());
  linear.block<2, 1>(2, 6) = a;
  linear.block<2, 2>(4, 2).setIdentity();
  linear.block<1, 2>(6, 2) = a.transpose();
  linear.block<1, 2>(6, 4) = b.transpose();
  return linear;
}

inline Problem AlgebraicPlane::multiplier(double initial_multiplier) const {
  const Matrix linear = linear_part();
  const double c0 = a.dot(velocity);
  return {.components = {{1.0, {q0[0]}},
                         {1.0, {q0[1]}},
                         {1.0, {velocity[0]}},
                         {1.0, {velocity[1]}},
                         {1.0 - alpha, {0.0}},
                         {1.0 - alpha, {0.0}},
                         {0.0, {initial_multiplier}}},
          .rhs =
              [=](double, In y, Out f) {
                f = linear * y;
                f[6] -= c0;
              },
          .derivatives = DenseLinearPart{linear},
          .end = end};
}

// z = v + A w with A = a b^T / |a|^2: q' = z - A w, z' = -P k q, D^(1-alpha) w = z - A w, P = 1 - a a^T /
// |a|^2.
inline Problem AlgebraicPlane::integrated() const {
  const Matrix reaction = a * b.transpose() / a.squaredNorm();
  const Matrix free = Matrix::Identity(2, 2) - a * a.transpose() / a.squaredNorm();
  Matrix linear = Matrix::Zero(6, 6);
  for (const int row : {0, 4}) {
    linear.block<2, 2>(row, 2).setIdentity();
    linear.block<2, 2>(row, 4) = -reaction;
  }
  linear.block<2, 2>(2, 0) = -free * k.asDiagonal();
  return {.components = {{1.0, {q0[0]}},
                         {1.0, {q0[1]}},
                         {1.0, {velocity[0]}},
                         {1.0, {velocity[1]}},
                         {1.0 - alpha, {0.0}},
                         {1.0 - alpha, {0.0}}},
          .rhs = [=](double, In y, Out f) { f = linear * y; },
          .derivatives = DenseLinearPart{linear},
          .end = end};
}

}  // namespace fde::bench
