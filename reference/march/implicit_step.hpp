#pragma once

#include <Eigen/LU>
#include <functional>
#include <vector>

#include "problem/problem.hpp"

namespace fde {

// The equations y_i = past_i + W_i f_i(t, y) of an implicit step, and 0 = f_i(t, y) in algebraic rows, where
// y_i and f_i are the values of a component at its nodes, linearised at some y. Matrices of values have a row
// a node and a column a component; unknowns are numbered component by component.
struct LinearisedStep {
  LinearisedStep() = default;
  // weights: W_i, of algebraic rows 1.
  LinearisedStep(const Problem& problem, const std::vector<Matrix>& weights, std::vector<Matrix> of_nodes);

  std::vector<Matrix> jacobians{};       // df/dy at each node
  Eigen::PartialPivLU<Matrix> newton{};  // of 1 - W df/dy, without the 1 in algebraic rows
  Vec mass{};                            // a component: 1, and 0 in algebraic rows

  // The correction of y that makes up for a residual.
  [[nodiscard]] Matrix solve(const Matrix& residual) const;
  // How large an f is whose terms df/dy y are all of one sign.
  [[nodiscard]] Matrix terms_of(const Matrix& y_size) const;
};

// What y leaves of the equations, where `next` is past + W f: next - y, and f in algebraic rows.
Matrix residual_of(const Problem& problem, const Matrix& next, const Matrix& y, const Matrix& rhs);

// How much of each component of y and f is rounding, at most.
struct Noise {
  Vec values, rhs;
};

// Rounding as it arrives in y and f: each is off by its last digit, f_i also by that of the terms that it is
// made of and of further_i. Newton's matrix passes that on from component to component: it is more than the
// last digit of y_i where y_i is small and driven, through other components, by an f of large terms.
//
// integral: what an f at the nodes adds to y. with_signs: gives sizes random signs, the same ones each time.
// Two methods that are compared have signs of their own.
Noise passed_on_noise(const LinearisedStep& step, const std::function<Matrix(const Matrix& rhs)>& integral,
                      const Matrix& y, const Matrix& rhs, In further,
                      Matrix (*with_signs)(const Matrix& sizes));

}  // namespace fde
