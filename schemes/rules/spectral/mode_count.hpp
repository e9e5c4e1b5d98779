// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Whether D^(orders) y = jacobian y has a mode that grows faster than e^(rate t): det(diag(s^orders) -
// jacobian) has a zero with |s| > rate in the right half-plane. Counted by the argument principle. Order 0 is
// an algebraic row. Also true where s is out of range of the count, as for an order of 1e-300.
bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate);

}  // namespace fde
