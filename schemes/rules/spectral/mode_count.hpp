// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Whether D^(orders) y = jacobian y has a mode that grows faster than e^(rate t): det(diag(s^orders) -
// jacobian) has a zero with |s| > rate in the right half-plane. Counted by the argument principle. Order 0 is
// an algebraic row. Also true where s is out of range of the count, as for an order of 1e-300.
bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate);

// The same for rows of one order g: the zeros are s = lambda^(1/g) with the eigenvalues lambda of the
// Jacobian, |arg lambda| < g pi/2. Its logarithmic norms m bound them, Re lambda <= m, where they are real or
// g < 1. Where that does not suffice, the eigenvalues decide up to a few hundred rows, and beyond, where they
// would take too long, it is true if a norm of the Jacobian allows for such a mode.
bool grows_faster(const SparseMatrix& jacobian, double order, double rate);

}  // namespace fde
