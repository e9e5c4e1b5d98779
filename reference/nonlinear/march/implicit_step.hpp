// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// The equations y_i = history_i + W_i f_i(t, y) of an implicit step (history_i: the history term), and
// 0 = f_i(t, y) in algebraic rows, linearised at some y; y_i and f_i are the values of a component at the
// nodes. Matrices of values have one row per node and one column per component; unknowns are numbered
// component by component.
struct LinearisedStep {
  LinearisedStep() = default;
  // weights: W_i for each component, the identity for algebraic rows; of_nodes: df/dy at each node.
  LinearisedStep(const Problem& problem, const std::vector<Matrix>& weights, std::vector<Matrix> of_nodes);

  std::vector<Matrix> jacobians{};         // df/dy at each node
  Vec mass{};                              // one number per component: 1, or 0 for algebraic rows
  std::function<Vec(const Vec&)> inverse;  // of mass - W df/dy

  // The Newton correction of y for a residual; not finite where the matrix is singular.
  [[nodiscard]] Matrix solve(const Matrix& residual) const;
  // The sum |df/dy| y_size: the size of f if all its terms had the same sign.
  [[nodiscard]] Matrix terms_of(const Matrix& y_size) const;
};

// The residual of the equations: next - y with next = history + W f, and f in algebraic rows.
Matrix residual_of(const Problem& problem, const Matrix& next, const Matrix& y, const Matrix& rhs);

// Largest rounding error of each component of y and f.
struct Noise {
  Vec values, rhs;
};

// Rounding errors of y and f after the solution of the equations: each is perturbed in its last digit, f_i
// also in the last digits of its terms and of further_i, and the iteration matrix couples the components. The
// result exceeds the last digit of y_i where y_i is small and depends, through other components, on an f of
// large terms.
//
// integral: the contribution to y of values of f at the nodes. with_signs: multiplies sizes by random signs,
// the same in each call; the two methods of a reference use different signs.
Noise propagated_noise(const LinearisedStep& step, const std::function<Matrix(const Matrix& rhs)>& integral,
                       const Matrix& y, const Matrix& rhs, In further,
                       Matrix (*with_signs)(const Matrix& sizes));

// Where f depends on y so strongly that y changes much within a step, the equations y = history + W f(y) of
// the step may have several roots. The one that continues the solution is followed while W grows: part W,
// with a part so small at first that y hardly changes, which is doubled up to 1.

// The first part: 1 where y hardly changes with all of W. weights: W_i of each component; jacobian: df/dy at
// the start of the step.
double first_part(const Problem& problem, const std::vector<Matrix>& weights, const Matrix& jacobian);

// part W_i; those of algebraic rows are kept.
std::vector<Matrix> reduced(const Problem& problem, std::vector<Matrix> weights, double part);

// The increment of y_i over a step for f_i = 1: int_0^length (length - s)^(order-1) / Gamma(order) ds.
Vec unit_increment(const Problem& problem, double length);

}  // namespace fde::reference
