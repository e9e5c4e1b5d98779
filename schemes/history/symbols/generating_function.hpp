// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The generating function W(zeta) = w(0) + sum_{k>=1} w(k) zeta^k at zeta = exp(log_zeta). Preconditions:
// -0.7 <= Re log_zeta <= 0, |Im log_zeta| <= pi, log_zeta != 0. w(0) is the weight of the newest sample: 1
// for implicit rules, 0 for the rectangle rule. The relative error is about 1e-14, except near zeros of W
// (rectangle: zeta = -1 at order 2; trapezoid: zeta = -1 at order 1). With the polylogarithm
// Li_s = sum_{k>=1} zeta^k / k^s, W is
//
//   rectangle            (1-zeta) Li_(-g)
//   trapezoid            (1-zeta)^2/zeta Li_(-g-1)
//   Grunwald-Letnikov    (1-zeta)^(-g)
//   L1                   (1-zeta)/zeta Li_(g-1)
//
// The argument is log zeta because small orders need points zeta that are closer to 1 than any double.
ComplexValue generating_function(const WeightTable& table, ComplexValue log_zeta);

// (1-zeta)^g K(zeta), where y = K f for generating functions: K = W, or 1 / ((1-zeta) W) for weights of
// increments. Bounded for |zeta| <= 1, also near zeta = 1. Precondition: the family has a regular_part.
ComplexValue regular_part(const WeightTable& table, ComplexValue log_zeta);

// (1-zeta)^order
ComplexValue difference_power(double order, ComplexValue log_zeta);

// log det, up to multiples of 2 pi i; the real part is -infinity where det is 0. Precondition: all entries
// are finite.
ComplexValue log_determinant(const ComplexMatrix& matrix);

// The change of the argument of a function f along the path p -> f(p), for a count of its zeros by the
// argument principle; log_f(p) is log f(p) up to multiples of 2 pi i. The pieces of the path are those
// between `points`, which increase. Each is halved until f changes on it by less than half of its size:
// between its ends, and to its middle, which detects a piece on which f changes and returns. Precondition:
// without its zeros next to the path f would turn by at most three radians on a piece. NaN where no such
// pieces are found, next to a zero.
double argument_change(const std::function<ComplexValue(double p)>& log_f, const std::vector<double>& points);

// Appends the ends of `pieces` equal pieces up to `end`. Precondition: points is not empty.
void append_pieces(double end, int pieces, std::vector<double>& points);

}  // namespace fde
