#pragma once

#include "weights/weights.hpp"

namespace fde {

// W(zeta) = w(0) + sum_{k>=1} w(k) zeta^k at zeta = exp(log_zeta), on the unit circle and a little inside:
// -0.7 <= Re log_zeta <= 0, |Im log_zeta| <= pi, log_zeta != 0. w(0) is the weight of the newest sample: 1
// for implicit rules, 0 for the rectangle rule, which has none. The relative error is about 1e-14, but next
// to zeros of W (rectangle: zeta = -1 at order 2; trapezoid: zeta = -1 at order 1). With the polylogarithm
// Li_s = sum_{k>=1} zeta^k / k^s:
//
//   rectangle            (1-zeta) Li_(-g)
//   trapezoid            (1-zeta)^2/zeta Li_(-g-1)
//   Grunwald-Letnikov    (1-zeta)^(-g)
//   L1                   (1-zeta)/zeta Li_(g-1)
//
// The argument is the logarithm because small orders ask for points nearer to 1 than doubles are.
ComplexValue generating_function(const WeightTable& table, ComplexValue log_zeta);

// (1-zeta)^g K(zeta), where K turns f into y: W, and 1 / ((1-zeta) W) where increments are weighed. Bounded
// for |zeta| <= 1, however near to 1.
ComplexValue regular_part(const WeightTable& table, ComplexValue log_zeta);

// (1-zeta)^order
ComplexValue difference_power(double order, ComplexValue log_zeta);

}  // namespace fde
