#pragma once

#include "problem/problem.hpp"
#include "problem/smoothness.hpp"

namespace fde {

// coefficients[i] t^power, added to f_i.
struct PowerLoad {
  double power;
  Vec coefficients;
};

// How the solution of D^(order_i) y_i = sum_j matrix(i, j) y_j + loads starts: the powers of its series, a
// term t^p of f_i leading to t^(p + order_i) in y_i. What cancels, to rounding, is left out. Of the powers of
// a component that are closer than distinct_powers the first stands for all. Throws std::invalid_argument
// naming the component for an algebraic row, whose powers follow from the others, and for a right derivative,
// which starts at the other end.
Smoothness linear_smoothness(const std::vector<Component>& components, const Matrix& matrix,
                             const std::vector<PowerLoad>& loads = {});

}  // namespace fde
