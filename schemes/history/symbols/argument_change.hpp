// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// log det, up to multiples of 2 pi i; the real part is -infinity where det is 0. Precondition: all entries
// are finite.
ComplexValue log_determinant(const ComplexMatrix& matrix);

// The change of the argument of a function f along the path p -> f(p), begin <= p <= end, for a count of its
// zeros by the argument principle; log_f(p) is log f(p) up to multiples of 2 pi i. Each of `pieces` equal
// pieces is halved until f changes on it by less than half of its size: between its ends, and to its middle,
// which detects a piece on which f changes and returns. Precondition: without its zeros next to the path f
// would turn by at most three radians on a piece. NaN where no such pieces are found, next to a zero.
double argument_change(const std::function<ComplexValue(double p)>& log_f, double begin, double end,
                       int pieces);

}  // namespace fde
