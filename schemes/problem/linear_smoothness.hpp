#pragma once

#include "problem.hpp"
#include "smoothness.hpp"

namespace fde {

// How the solution of D^(order_i) y_i = sum_j matrix(i, j) y_j + constants[i] starts: the powers of its
// series, a term t^p of f_i leading to t^(p + order_i) in y_i. What cancels exactly is left out.
// Throws std::invalid_argument naming the component for an algebraic row, whose powers follow from the
// others.
Smoothness linear_smoothness(const std::vector<Component>& components, const Matrix& matrix,
                             const Vec& constants);

}  // namespace fde
