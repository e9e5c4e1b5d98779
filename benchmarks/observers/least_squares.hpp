#pragma once

#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"

namespace fde {

// Minimises |A x - b|, one column of x for each column b. Precondition: A has full rank and at least as many
// rows as columns.
LongMatrix least_squares(const LongMatrix& a, const LongMatrix& b);

}  // namespace fde
