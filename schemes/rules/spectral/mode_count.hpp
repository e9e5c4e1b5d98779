// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Whether D^(orders) y = jacobian y has a mode that grows faster than e^(rate t): det(diag(s^orders) -
// jacobian) has a zero with |s| > rate in the right half-plane. Counted by the argument principle. Order 0 is
// an algebraic row. Also true where s is out of range of the count, as for an order of 1e-300.
bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate);

// The same for rows of one order g: the zeros are s = lambda^(1/g), with the eigenvalues lambda of the
// Jacobian for which |arg lambda| < g pi/2. A logarithmic norm m of the Jacobian, Re lambda <= m, bounds |s|
// where g < 1 or all lambda are real; otherwise a norm does. Where the bound exceeds the rate, the
// eigenvalues decide for up to 300 rows; for more rows, where they would take too long, the result is true.
bool grows_faster(const SparseMatrix& jacobian, double order, double rate);

}  // namespace fde
