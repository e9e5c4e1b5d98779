#pragma once

#include "quadrature/gauss.hpp"

namespace fde {

// The x with the least |A x - b|, one column for each b. A has full rank, and at least as many rows as
// columns.
LongMatrix least_squares(const LongMatrix& a, const LongMatrix& b);

}  // namespace fde
