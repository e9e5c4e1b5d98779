// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde {

// The term coefficients[i] t^power of f_i, one coefficient a component.
struct PowerLoad {
  double power;
  Vec coefficients;
};

// The powers of t in the series at t = 0 of the solution of D^(order_i) y_i = sum_j matrix(i, j) y_j + loads;
// a term t^p of f_i gives t^(p + order_i) in y_i. Coefficients that cancel to rounding count as 0. Of several
// powers of a component within power_separation only the first is kept. Throws std::invalid_argument naming
// the component for an algebraic row, whose powers follow from the others, and for a right derivative, whose
// series is at the other end.
Smoothness linear_smoothness(const std::vector<Component>& components, const Matrix& matrix,
                             const std::vector<PowerLoad>& loads = {});

}  // namespace fde
