// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"

namespace fde::bench {

// Minimises |A x - b|, one column of x for each column b. Precondition: A has full rank and at least as many
// rows as columns.
reference::LongMatrix least_squares(const reference::LongMatrix& a, const reference::LongMatrix& b);

}  // namespace fde::bench
